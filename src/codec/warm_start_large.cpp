// Made by tests/bench/train_warm_start.sh; do not edit.
// clang-format off
#include "codec/warm_start.h"

namespace unstep::codec::warm {

const Table kLarge = {
    {{
    674, 492, 256, 170, 156, 508, 323, 209, 261, 425, 317, 1112, 615, 512, 415, 83, 139, 233,
    }},
    "00001Z?^06aDZAO^072mE]o^0?P6V5[^0?^4bNW^0B[oiZ;^0DClFJ_^0K`fBEK^0MhXnRW^"
    "0Q_i9m_^0jpX6fo^0oJPBR[^16ndnQ7^1<:;nNW^1DHGfZc^1RAJan_^1U0A^EK^1_lPR=S^"
    "1aYkBMG^1i]X]ao^1oVFR^c^2MJI5bC^2X:12Rk^2YPDb5C^2[IpfMC^2a^]ZFW^2dBJ^V[^"
    "2jglJMG^32lT5]c^35mU2>_^36CVnQK^36G=J6W^39=Zj:[^39M<EZK^3;58bRO^3<KYRNS^"
    "3BOV]iW^3B[p]j?^3P6^NVc^3QV<abO^3WB`bEO^3pR3b9S^3_H1ifW^3hf3^Fg^3l4<bIS^"
    "3l69QbC^46A5Ij[^4CH>]f;^4D4C:Z[^4Ee[mfO^4KABnN[^4OJRJYC^4ZCc2:C^4b<VbNS^"
    "4c9kV=G^4f3dmZC^4j<^JE_^5@pgQRK]5L>;mbK^5M<AY]o^5XlCUb7^5_RMQ^;^5lmfFZc^"
    "5nh52B[^5o3i1Yo^6Jn7ZEO^6^O7eVS^6kcL]n3^7@DiBQO^7Jgn:JW^7LINB=g^7LeP^IO^"
    "7VJ=F=C^7WaX>Z[^7`g]1mc^7aRVjQK^7fA`2EO^7gY7JBO^7hTTNN_^80_4iaO^83><Mmc^"
    "870EUi[^87l4^QC^8?Alj63^8AeAF=K^8J;D=N7Z8McNJ>_^8[8P1VO^8k4H5Yg^9<;:UYc^"
    "9A[OjVk^9Fe>FMK^9K1T^Vc^9`[UJAO^9ckA>N[^9hINba;^9kg^j2K^:09TnRS^:23=2a7^"
    "::7d^9C^:>O9N5k^:CooA^[^:DOQJfk^:L?RfMO^:TnDb=K^:YbLUak^;1GX5nS^;5WSiMO^"
    ";703I]?^;MIfR:[^;aJX:5k^;jNOjU?^;j^;:];^<3T=Q^W^<5MH=YW^<61pB9O^<7HBfa;^"
    "<9f_R1[^<;j72Jc^<B44bF7^<DQ:f>W^<DXhnNO^<SBneU[^<TC6bES^<p3;NMG^<c61NZg^"
    "<fUSi^7^<j[QanS^<mW`ZAG^=0G6:Y?^=7IYM]o^=7QGUZ7^=BJ8n>W^=Ee9J>W^=MEPV:[^"
    "=UOG>a;^=XAKfFc^=YHniag^=[U[jMO^=`KlAnS^=`P?FAO^=gXl1^O^=hTOmfW^=mMMEac^"
    "=mX7ZR_^>7U6nY?^>=EU5iS^>GdMNBS^>Lm^Ib7^>P1^^QS^>SbNZ>_^>XW3ZZc^>^[0f9K^"
    ">`C<ZAK^>mndJB[^?4pWFMK^?6]VFFc^?G39BJc^?H=Y2Vg^?I0R2QG^?K?^9Yo^?ONcF=W^"
    "?XP]:J_^?b5IbVW^@9TG22O^@>H0jR_^@L=aNBS^@Q;YbAK^@_`<FN_^@lLeY]o^@n4b6:o^"
    "@o<mRBc^A0fAU]o^A;k5>F[^A>5>f:W^AGF_bB[^AXDHRMC^Ae`K2^c^AhEiU^C^AmU<V2W^"
    "B0I=nJS^B384fMC^BLQ=AaO^BQM7F9O^BSFj:^_^BS_SUNK^C3m2Jbc^C;?g=jK^C=YHmbC^"
    "CBb>Z9C^CGQ4A^;^CTTQ5jS^CXA3nNO^C[oC5F3WCeBU2F_^CkWUf1S^D3K=:JW^D5Z]BQK^"
    "D:^h1RG^DE:iU^;^DVp>V2C^E38K2NK^E7G1]iW^EDYjIVG^EFcDN=C^ELfPBB_^EZcWB^_^"
    "E^VN]U_^EkK4=Qk^EoZ9J5S^F2U_]nG^F6hfJ=W^F?^niVG^FFPCR=O^FL<mea_^FOT]ZQG^"
    "FPE5]^?^FRhJ:Rg^FZPe:Zc^F]7nmU_^Fa2ARIW^Fa@iEZ3^FbRX2QC^FcZSmUk^FeJOS@c^"
    "Fi0ln5O^FjVn:9O^Flc65]_^G0PA6Vc^G6T>AYg^G:NPfEG^GFT8n:_^GFiUF=O^GWhG:B_^"
    "GXj[jk7^Gdc:J5O^GhA`bAO^H5SO9QK^H6H>=^S^H9756MG^H9LWUfK^H@aU6YK^HFVcBU?^"
    "HORBB5g^HPTT2:_^HSCJjEO^HVpmb=C^HYCEnNg^H`32VAC^H`f2VB[^Hk8[bIC^HlXd>Jc^"
    "I:=KYiW^I>[Y>Zk^IBJ`j9_^IG>^Fbg^II<;AU[^ISYZmMg^IeXRJI?^Ij`oB>k^Il``VZO^"
    "Imo=Ie[^In2bFI;^IncQ1jW^J0Qc5ZK^J2M`nBO^J;]CnB[^J<NVbAO^JF?^mac^JPA_2EK^"
    "JS7=UYk^JVR4AfG^JXX7n>_^J`H<VF_^JeF?Ub?^Jmd9MZ3^K0=d1Z?^K4p7BNo^K>ZiN:O^"
    "KGJ2ZMG^KRQ]jFS^KVXMQV3^KYdHIf_^Kde@MnS^KfRP2:K^KlXd^R[^L1SH9^C^L9O[M^C^"
    "L;YoNQC^LRc;]fW^LU6>aiK^LUP5nYC^L]eVa^C^L_jDmNS^L`VINNW^La4gRFS^LklXZUK^"
    "M6eJ2QG^M@4b1Q[^MA=dVZg^MG?>QZK^MQREj5S^MX@LfEW^MY`Qb5O^MZVm2Zk^M`Ql:Zc^"
    "Mc2IV9K^MgPW:Rc^N6ZX:Jg^N91eM]k^N961nNO^N:H3ZU7^N>Kjn>[^N?1166O^NDnPMaO^"
    "NFpC6B[^NYeMfNg^N_LNm^C^N_e`6a?^NfnajZ[^O1iO]f3^O6O2Y^C^O:GIQ^;^OiGQEZ3^"
    "OnZWN>[^P2lCZ9K^P>4]:MO^P>>=Z5g^P?VK6;7^P@0=e]_^PBcfFEG^PE32IYo^PE8GVQG^"
    "PG==V=K^PJlEF6W^PL0DAESWPYLM9Mc^P`YLi]S^PcbGJIC^PjETZ:[^Q3BSYYc^Q3nX:V_^"
    "Q@SRZNC^QAefiYo^QGVNER;^QO3InIS^QS4@REO^QX]@iY[^Q^=V>^_^QcGDZIO^QgSZnV[^"
    "Qhia25S^Qjco]Yc^R9o^N2c^R:AHZQG^R==[^AS^RBF0EaW^RDkU6]?^RF]f6BW^RNUCFU?^"
    "RO<oaic^RVYk2=K^R[3BB1S^Rd25^IG^RfH]nN_^S1PK6M?^S5[L2YC^S>J=n9K^SFjYY^?^"
    "SG<djN[^SOc_fRW^SaI:ZV_^Sj7lVRW^T:6>Y]o^T;=gRF[^T?VNJEO^T@]B>^o^TFDREiW^"
    "TG@ANY?^TGko=j?^TJYhA^;^TQ3Z]U_^TR[W6J[^TSjI6Y;^TT@RYYg^Ta3A6>?^Tc8QN9[^"
    "TfgY9fO^TkD=2^_^U02;R1k^U0e=6A[^UFmOJY;^UG:7nJW^UI8?UnS^UNDgnUO^USk_]ZC^"
    "UW3Yj=W^U_g;iU[^U`I^]]_^Ul5OUUg^UoPFB1W^V21MR]G^V4cR6J_^V5fC>BW^V7][V]?^"
    "V90DfE7^V9CK=]o^V=2EVEO^VEQ^iUk^VHiN^9S^VIl8RAO^VJ:=jJ[^VX?jBA_^Vp0Z=^S^"
    "V`UK66K^VejLnRW^VlNI:]?^VlSdn=C^Vm7L^ZS^W0DTj2S^W:1ZJ5k^WF_b62W^WMjMRF_^"
    "WPXK:>3^WQ>]VEG^WSMi]V3^WcU?RB[^Wjln:Xk^Wo>`2IO^X<P<Qic^X>WP2R[^XCPibEW^"
    "XF6fiV?^XKS`BU?^XRhJ2Zg^XZL^^MK^XbQFIY[^Xm]`6AG^Y8N;J=G^YE7e2MK^YHnkiZ;^"
    "YXM;N6S^Y[d?QE_WYiAg6=k^Z51SnV[^ZB^6Ij3^ZLkD>BW^ZXED=^3^ZYaP^YG^ZYe7::_^"
    "ZZmY:R_^Z_adN9K^Zmo=Z=O^[0AYeRO^[71DB6[^[:`ZREK^[C_Kmn3^[GhRfFS^[KOS6b_^"
    "[[=;R5K^[iCUYnS^[jcZVJS^[lTc:EO^pFWeBEK^pO[pEac^pP49jA7^pPn1V:_^pR<cRMO^"
    "pd:aAVO^pi7kYV3^]0hhj2C^]4X?:V_^]8K@F5S^]<<0B6S^]>C[6F_^]?<Z^:W^]AQiBB[^"
    "]LY_>IK^]d_ZbVc^]nL1FEK^^4EDBNW^^5e7:E3^^9k=^Fg^^Am1U^C^^OAFMmo^^SJlZA[^"
    "^V;PJ>S^^h7HQZO^^l6cnMG^_4eP=b?^_72kNVW^_86]ZMO^_?4^BUG^_ES3B5K^_G94N=K^"
    "_L2N>N_^_M2GFR[^_R9_fEC^_T<nYe[^_[InJQ?^_`6RanS^_eC;6IS^_mY=mMg^`4JMN>W^"
    "`5Lb>fk^`=jdfRW^`>VIa^[^`KDQN6G^`RjDMVO^`Un]ijS^`c8iRUG^`hG6jB_^`l4HR9g^"
    "`m6ZB:S^a1cKNBS^a5eL>6c^a:0M>2[^a<U8f9?^a=S8EmW^aB_?:Nc^a[=_N^g^a^lg:9k^"
    "acO=V=[^agmK:g3^b0;a=N?Zb8_nYVK^b?Rh]aW^bCkORF_^bIBfjZ[^bPNpEnK^bUV@5>3P"
    "bcmmF>S^blL;]ac^boYCiVK^c5:>=nG^c<jBf>[^c?O2Z=S^cAhEi^;^cEhK1]k^cI@:f1W^"
    "cJF?]Z7^cMlIZe3^cXU^B6_^cXkAmY[^c_H0bVk^ch6b^FS^d0W>F:7^d0iN5Mk^d;cOfR[^"
    "dH`dIbC^dJ3MY^3^dN5NI^;^dNA9Z6W^dSdofUC^dX<5^UG^dZoAE^?^d^^WVNW^deTcQbK^"
    "diC36>[^e0cJBBc^e1XE1eO^e<fhYak^e=Vmb:c^e>F[V2[^e?3UZIG^eFMS1^C^eMA;ZUG^"
    "eOMJ5VG^eSGPFMK^e[30^Y7^ep4RIRS^epVhEYS^e]_jjZ_^eaVPEU?^f3Sa:Jg^f6BX61W^"
    "f793FRc^f96P=R7^f<4mJZO^f=42JV[^f?TOf9K^f@Ahf6G^fB8jV5S^fD2]JV[^fUSk]]k^"
    "fZ[D>>_^fpVi5jO^f^a_f>c^fc>IJ>g^fkOgR>O^flNKbUC^g<GfJe;^gCPh:^_^gGi:bIK^"
    "gIQD>FS^gV:mf>S^g`891Yo^gaejZ^G^go[[>J_^hC>66R_^hEiWUV;^hUI^9iS^hXkD]fO^"
    "hZ`CjF?^h^6Qen[^haZMfIG^hc_CfEG^hd6eVRS^hgNKUf7^hjdYR>W^i0NoR1c^i?5[YbO^"
    "i@DMZEO^iD9CJ6W^iI>Dbbk^iKccEb?^iVUnVM?^iZAoJZc^ioo71UO^j189VR_^j6dcjZ_^"
    "j<ha5]_^j=[bYmg^jVcNjE?^jWJl6fk^jZ1?BIG^ja7B]f;^ja<4BN_^jfTm:fo^kDE4=ac^"
    "kINI:BW^kPn`FNO^kR=RFQK^kVi6fVO^kZdV6A?^ki`bjRW^l::8FFK^l<l]mf?^lFh?mmo^"
    "lJZhVNW^lVAGe^O^lW_mfBG^l]?HNJg^l`DOB5c^ldN5N1o^lj61MZ7^m77RV5O^m<K^eNC^"
    "m>8ME]C^m>APn^c^m?ZW^5W^mCI_Mf[^mPSaiY_^mZN6]Qc^mc<hY]g^mcOUZ]C^mgCDBEO^"
    "mjfn>IG^n3U`:5W^n6FCj^o^n<kdm]W^nfFPZM;^njGO2AS^o1G0:1S^o8R`M^S^o=7QF:G^"
    "oI0OJQK^oIYS2^_^oK_ZNAO^opTnfEO^ocAhF6S^od?NbUC^oe;iaeW^olXJ29G^00001Z?^"
    "02KbRQO^02[N6=[^0RIeEUo^0heY>UG^1<p::];^1BAhR1S^1BTQ6RG^1N1[b>W^1i]X]Yk^"
    "23?LVYK^2@?gjUK^2AOajjo^2GbVbV[^2Nfe21O^2Ue=BVW^2UlIVAO^2YPDamC^2dBJ^VW^"
    "35mU2:_^37fGaM_^3;58bNg^3@UIRbk^3@^_aiO^3B[p]j?^3DG5>]C^3F8_F=O^3NHDVV_^"
    "3Z0a6EK^3akR:R[^3g^LfIO^3jFIbMK^4CH>]jS^4F?N6Zc^4ZCc2:K^4p0Sba;^52K_jIS^"
    "5;?5nJW^5Kgo=Y[^5XlCU^O^5^KK]fO^5b9P6EO^5iTDbEC^5mGFMZC^65Ep25O^67DJ:VW^"
    "6Q8NjV[^6QH]NV[^6REefEC^6cCO2J[^6gHi>J[^6iCQ:>c^6kcL^27^7LINBEg^7S3Z5Ec^"
    "7TEIbVW^7[6YEMcZ7hTTNRc^86h`2i3^886c5UW]88jV^RW^8>FZR^k^8?Alj9o^8GRVRUO^"
    "8P:@JB[^8k4H5VG^8k`]9]W^92HSJfg^98=>jbc^9:6G2VW^9A[OjZk^9o37:aC^9oD2j]?^"
    ":6=ERV[^:9cTnV_^:<=efYG^:<AB]aS^:>O9N1k^:FKiZR[^:MKfZIK^:TnDb=S^;1GX5nW^"
    ";7l;2bc^;>4=mNC[;B:DBUK^;M;MNQ?^;O=XAUo^;[nBbZ_^;aJX:1o^<38SfYC^<IJ4:RS^"
    "<R`4jQK^<TC6bEW^<TgA^IW^<W4V=Ug^<XX1Z:W^<c61Nbc^<m@K6bc^=7IYMYg^=>:Ink3^"
    "=ChXE]G^=L4FnQK^=SQPnZ_^=WSpZRW^=YjAfES^>1e5QR;^>Kao^QO^>OnKbV[^>k^E9F;["
    "?A1;AfW^?E]>>QK^?Fh>j]?^?UW[^Z[^?`k2^Z[^@8kGJVW^@9mdQQk^@BQ`fUO^@G3U2Z_^"
    "@MYNjQS^@^gf6]G^@eX;2QO^@gF4=Qc^@lLeY]o^@m`8BJW^@mm;^RW^A3Thn6W^A418nAK^"
    "A7BO^QK^A?N::BS^ABE9JIS^AF[onfg^A^FZ6UO^A_[4ZZ[^AkS5fbc^B3cK>VW^B5kC>IS^"
    "B8aUZZ_^B:iK>R[^BKpoBUK^BL5E:QK^B^SBUJG[B^klZF[^BdOg:EO^C;ZI^a?^CGQ4AfG^"
    "CYTHNR[^CeXG2Z[^ChYURYK^CkWUf9G^Ck]dV>[^D1eAVMK^DFlVRNW^DVp>V2K^Dc0GnRW^"
    "Dj4V:e7^Dm6mM^W^E?NcjZ[^EFcDNAC^EXP0:=S^Ec<mNZ[^EdoaiY[^EeY:jNg^F6hfJ9W^"
    "F;=a=NG^FFc]jVW^FHaE>RW^FPE5]^C^FRBI:J[^FRH1UUo^Fa@iEYk^Fc?H>IO^FeJOS@c^"
    "FeiN>AG^GG<GnVg^GMbgaQS^GlT[:FW^H57`Ffg^H6Ap^YC^HF6k]YW^HORBB5g^HYCEnNg^"
    "Hb`BjMS^HijeieS^I87IfQK^IBJ`j9_^ICJoZIS^IY>@JYC^Ipg>nAO^I^>VBBO^J2M`n>O^"
    "JDHmB>[^JHi6V9K^JHm:B5O^JNM=>QO^JRKNZZ[^JS7=UQg^JXX7n>_^J^1h:jk^JdD]6VW^"
    "JeF?Uf?^JejJRNg^JhYRnIK^Ji@W:Z_^Jmd9MZ;^JoDTF9S^K0=d1^G^K>ZiN>K^KRVZbR[^"
    "KXU[Va?^K]7Ob^c^Kmmd1M[^Kok5ZYC^L1SH9^?^L5hiV]C^L=InmV7^LFL5ffk^LI:o5EkZ"
    "LO1TJV[^L]79>UO^M8RZ2QK^MELLne3^MJ2?FZo^MY`Qb1[^N1?7Ne7^N4@<fMS^N91eMYo^"
    "N;6Y^Rc^N>8kRUO^N?116:_^NDnPMYW^NImjVQO^NQ@@=N[]N]:`a=_^N_LNm^O^O56?VEG^"
    "O;pAbNS^ONRNiU_[ONk8Z]G^ORY<FRS^OZ40f>W^OafXbB_^OdnmQZK^OhAW6YC^OhGGnAS^"
    "OiGQEV?^P>>=Z5k^PD4`VV[^PJlEF2W^PSJfFY?^PXA6jRW^PZh`bV[^Pm8bnV[^Q9=KjY?^"
    "Q;3pYVG^Q=XX:R_^QAnh2MO^QO6<2N[^QRIcnJc^Q^=V>^c^QhKlEN3^Qi3JZZ[^R=2n5bS^"
    "RFnj]mS^RG^I69O^RO<oaic^RVE[BV[^RX_l6UK^Rp_@:R[^RfH]nVc^Rg?62JW^RimljIO^"
    "RneYNQK^S1PK6Y?^S7X82o7^S8[fij_^SC<K]Yk^SFjYY^;^SNmZ>IO^SfnpfF[^Si]SbQ?^"
    "Sj7lVRW^T;=gRF[^TGko=n?^TJYhAYo^TKD1jAO^TRScbES^T]lk1UW^Tcbo6BW^Tl036AK^"
    "UW3Yj9[^UZpPBfg^V8]JIUW^VC`0bUO^VIO_BZ_^VIl8RAW^VOIR=Yk^VU]>2]?^V`UK6:O^"
    "Vo9MFQ?^W3cK^^c^W52hNaC^W:1ZJ5[^W<aaiQ_^W@dj2UO^WEEZbJ[^WF_b66W^WSMi]V3^"
    "W`L;]M_ZW`LK6UO^W`^[6MO^WcJE>YG^WfE<jRC^Wjln:`k^XCPibM[^XF:<VIS^XW43AQc^"
    "XWW`NMO^XZ26ZMO^Y13obIK^Y1OCnFW^Y6Oe>VW^YCh:QVC^YU:[VV[^Y]5gN9O^Y_g2bFW^"
    "Yf1OB5K^YiAg6=k^ZB^6Ij?^ZO^RVB[^Zd<YQiC^[2ZBVMG^[71DB2[^[C3h:=K^[C_Kmn3^"
    "[UW8bN[^[V<KZQO^[ejYZ=O^[i]Gb^g^[mHOB=G^p=p;:UK^p@_;JMO^pAF0nUK^pBB@BJS^"
    "pNCQEIc]pPn1V6S^pURd2QW^pVm[NF[^pjAQ:Zc^]1gc9VC^]4i:^V_^]5cpZN[^]CEE^AK^"
    "]FVpN]?^]LEn2YG^]R1C^=O^]fi8^Z[^]o91ZFW^^5e7:]7^^BD8QU[^^DiT>QO^^I;U:AS^"
    "^OAFMmo^^SJlZ=[^^VJ4jMC^^WGd>NW^^nj7iV;^_4eP=VC^_6JebZc^_7cCRV[^_?aNRES^"
    "_H7df1O^_L2N>R[^_MSZBVW^_djIR>W^_fE`FUK^_lMg^VW^`5bGVQO^`O>ViYW^`RcbnUK^"
    "`UfM:k3^`]T@bZS^`_KL]bS^`l4HR9g^`oi;ZYG^a1cKNFS^a8HQj9S^a?hbBRW^aB_?:Rc^"
    "aJ@TR9_^aR>e2NW^aRQ0je7^aRalZe3^aT_E:RW^a^lg:9k^akm@=aW^bPNpF2S^bPcabRc^"
    "bVhdbQS^c17@^QK^c2>l>=[^c8ZnBV_^c9[hRZ[^cE;YBIK^cHRWRQO^cR39=MW^cajZnR[^"
    "ch6b^JS^d0W>F:;^d57afUK^d6:4fRO^d>EA6IS^dH51i^W^dJ3MY^7^dJOjEQWZdNA9Z:W^"
    "dSeGVbc^dWoiN9S^dZoAEb?^d^KkRNS^d^XnnRW^doR@^YG^e<fhYV7^e>F[V2c^eFMS1^C^"
    "ep8522S^eanS>a?^efTEZW3^f1acjJc^f=g:eVG^fFD7B]?^fLg@^2[^fMa=^a?^f]i42F[^"
    "fd1QaJ;XgBLceV3^gDHlJbk^gQXEfEC^gRfRAJG^gcDA>YG^gh]XJUK^gjQNb^g^h;Z7NQK^"
    "hE9mBbg^hJ8obJW^hZ`CjF?^hZ`IJa;^hcpkZVW^hd6eVR_^hd]ejVW^hgNKU]o^hj9i^k7^"
    "iKccEZ?^iZ:^NR[^j;m]6UK^j=[bYmk^jB1<AFG^ja7B]fG^jgCf:RW^jjB?=Mk^k7WibUK^"
    "kPZo=jW^kT:>Bfg^kU=m=j[^l::8FFK^l:e9>R[^lFh?mn;^lPJV2F[^lW_mfBG^l`DOB9_^"
    "lbl]Zbc^ldN5N1o^ldN[:UO^lo5j2AW^m9_<faC^mFZg>^g^mHR9FEO^mI74VRk^mM5OQZK^"
    "mc<hYYg^n^MERV[^o2?DBUK^o4><b:S^o9l@ibO^o=7QF:G^oBNH:IO^oBf]nMO^oFPSfIS^"
    "oIX6bRW^oK[SVE?^oPEQnR[^oXUZ6g3^ocAhF6S^00001n3P0]D99Qg^0`22BB_^0n;g1N3^"
    "13jiiEoZ15EY=R3^1CNP9ak^1P3NEmc^24l?MN?^26Fnaf;^2VcfeR7^2YQ_nBS^35mU1nC^"
    "3B[p]f3P3hf3^?C^49]aQZK^4?LdMF3[4@gS]Qo^4b_;5j7^59DGe^3^5@N:1R;^5bEaFR_^"
    "6D>FQ>G^6p>h]b;^7Jn^mIk^7LINA]g^7O7GF5k^7lfFEU[^8L04Q]o^8X^<=j3P9>hS9jS^"
    "9O`A1Qo^9UOCmMk^9Vj3=Yc^9e2j9ag^:OFgER;^:VPYQYc^:WkHb5S^;8H@e^?^;bJQB=W^"
    "<2AH=V?^<F_i2>[^<QK6N1g^<[B;Qb;^<a1>MMk^<bKm]Uk^=Zhaf:S^=[j>n=O^=b2T1Yk^"
    "=gViMn3P>Tk2YYo^>XZHjEo^>eb`QJ;^>k>R^=[^>llR]R3^?;5IYj3^?gnpZ9o^?lS8mRC^"
    "?mmhAfC^@NJ`EU[^@R:6VF7^@d^@J9S^@mTNQn;^A:BV=b3PA`Lm>2O^AaNJFEk^B1D[1ZK^"
    "B42T:=S^B73]mAkWB8NM=Qo^BXGkj6k^C0b^69c^C0kAEZ7^C853QR;^CYlZf2C^CZn7n=k^"
    "CmRAb9_^D;e?mBK^DSeb=b?^DjBK^Ag^E<fUR1W^EBUXMIk^ED0Ga]g^EdM?eQg^F9V_N9_^"
    "FCVn1]k^FPE5]b3PFcb9J=g^G6FC>=_^G6OLYfS^GGG:QRS^GM6=MB7WGNPl]Uo^GZ[Zn:S^"
    "GpYcYak^Gm?db6O^H36M:I_^HN7S1U_^HORBAmg^Hion^>c^Hoo:Eb?^IBJ`j5_^IlV:f=[^"
    "JRi51^;^JXX7mIk^JZ2g=Uo^JcOpJ:K^K63f>6W^K;jNVQK^KRO[En;^KYYMQV3^K_=bmn3P"
    "L2d0:B_^LEH9nFg^L]IZ1JO^LdSL=R7^M5J<>9_^Md:2MIo^MeTaaf?^MlC]f2G^N>ggZJW^"
    "NF1YeaS^Ne;H1f3^O1iO]f3PO;X1V>_^OX3fYjK^OhkTQVG^OnZWMEcZP05F]Qo^P>>=Z9S^"
    "PhR:eZ3^Po[m1Qo^Q57_>>W^QQSTEn7^RDL2nB[^RKL[]jC^S4MO25_^S:<QmMg^S;WAA]c^"
    "Sp49EQc^T1=Xmmg^T;=gQYg^T=k`ZN[^TGko=V3PTn6F9bG^U>n41VO^UD]6mF3YUF7f=Yk^"
    "UT@]9^3^VE^LQYc^VG9;aio^VgV3eV?^WF_b66W^WSMi]j3PWaO;=]k^XJOnQZC^XP?1MF7["
    "XQY`]Ug^Y3QH65k^YJ6Tej;^YQ@G1V3^YVdpMn3PZU0SQFK^Zp:E]R7^Zm15]mg^[MDdF5W^"
    "[[`kmEk^[];[Ab;^p=XSE]c^ppbAQb7^piPI=j3P]FdR29S^]OZ`9jK^]`RN1ZK^]fAPmAcY"
    "]gp@=Mg^^5e7:5_^^CT[n=o^^`94EYo^^gBfQQg^_@D?Z5[^_I:Mej7^`=4IVMo^`C3U=b?^"
    "`OXSJ9S^`l4HQj3^a1cKMQ_^a3>:aYk^a3mk:6_^a^lg:>7^b2da1Yc^b5RZ:2C^b6T7BB3^"
    "bI8A69_^be]?YZ3^c6TmQV;^c<D0IEoYc=^_]Uk^cEhK2Io^cKgVYb7^cXLTfIS^d<alV>k^"
    "d=EF1Qg^d>`5Af7^dU<^b=[^d_<mEQo^e>F[V:[^e?H8^Eg^eK4c=b3PeQlBR9[^eY64]]k^"
    "fB6h1^G^fGejmIgpfHed6:W^fI@Z=Uo^fNpLNIg^fk8AUj7^gA]NEb7^gEUn2>g^gHg@QZ3^"
    "gNKUmn3Pg^0`>=_^hH<:6=[^hLWM1FC^hSa?=N3^hZ`Cj=c^i?5[Z6[^iQYeR:S^iSGeMI_^"
    "iTbTa]o^iWPMfMW^j5?Lef7^jNIoN>c^jTI;1]o^j`n9BF[^kGAYYnS^kQ0;R=W^kX9GQRC^"
    "k]hJMJ7]k_C9]U_^kmL0Yik^lGi]62?^lW_meV7^lZMfjBW^l^i`1Uc^l`DOB5S^m@aGEeo^"
    "mW>0f:c^n:ZN]^3^nYd<nA[^nc[B1f3^niJDmMg^nje4=]g^oP]^R6S^ocAhF6W^ojKZQYg^"
    "00001Z;^0593en?^0:l;34o^0Ab3nno^0^`@^6[^0nRUV9K^1pj_N5o^24W0B0_^2TJbf^_^"
    "2_AM>>G^3B[p]j;^3LEQemc^3`AR>9_^49h3K77^4?>0NAO^5j81ZA[^64b`>J_^6Cg96i;^"
    "6LT=e:KS6_1>V9S^6kcL]mk^70Qepn3P77MSZQK^7<:p2CK^7Qi]>=_^7ee]V2G^8?l>Nfg^"
    "8FJ2ibc^8pPU38k^90fKVJ_^99BQQno^9OI3[8k^9P6oVIG^9jS969o^;1GX66K^;^Kp^V_^"
    "<QI96i;^=CQCj8c^=D<Z2F[^=Ld0^j3^=bp3>ec^>^Xm[>G^?17INN[^?;_[?77^?@UXV9O^"
    "?]_66;C^?_9j_33^?eK[>no^@3N7>MW^A6>:EIC^A?1U6YS^ADjgnjk^AfjBf3?^Ahd?KCC^"
    "Ai6XmAG^BH37B0c^BXcF1A7^BZ?9N:?^C=YHmio^D@06b:C^DONEiek^DcJF>1_^EIPV^UC^"
    "E]LW6:C^Ee5]j8g^Eljf>2G^FPE5]io^G?98MM?^GR[cNB[^Gb:2VEO^H?CP6GC^HMdL:i;^"
    "HU2Q>EW^HWNABaC^JJ[2mLg^JQ96Qlk^KZZNAB_^K_=bmf7^L>5nFm7^L]2LZm7^Lh^BnF[^"
    "MKnLb0g^ML8RN1k^N3_0nV[^N?116FW^NFZ7j<g^NNO@>2_^O1iO]jC^OnKcN9[^P4@=NF[^"
    "Q92[C<g^Qkk9kH[^R`:CV5g^SdQ_^>_^TGko=nG^U6`1mY3^U7odBaC^UmplN5k^VLYJ^=k^"
    "V`UK66[^W03Z=fO^W;;3kKK^WMYO^FW^WSMi]Z7^W]7^f9S^W^gpmM?^X:A<FFW^XP0=R=W^"
    "Z`E<N:O^ZdU=R8c^ZocKUmW^[C_KnAW^[[Me6m7^[b[j>EW^pF69^>[^p]cBESC^piPI=jG^"
    "]A>bJm7^]QKD=fo^]f2pnIG^]kg6n:S^^ILlN6C^^OAFN1k^^lg;mek^`>p8jAW^`?m>:?""?^"
    "`ZhOZQc^`[eVFJ_^a1TWRA[^b?Rh]j7^bTQFbRS^c=3Y6jk^cAiVNZk^cLQh?33^cQGeV1k^"
    "ceCen1k^dD@D>=g^dfo=V=c^dgZS^J_^eE@I>R[^eK4c=j7^ehPS34o^f[S7FBG^fk1FN2K^"
    "gNKUmj?^gfOJNno^hL@?W4o^hPbCb>G^hYU=Vi;^hbTG_?""?^hgJE65o^in>d62C^j=]3>6;^"
    "jXV9j7G^ja7B]mg^kXdZ:Fg^k^X36no^kcN0NBK^kn6B?77^l2l?Uag^lA3en>S^lFh?n1W^"
    "lQPQ_;;^ldN5N2;^m5pB]lk^mHSWVAW^nJ?2]mc^o=7QF:O^oLU`QjK^okL[AFo^00001eo^"
    "00Y:i:GR0WVm6ik^0ZS6bAK^1W<AG8k^1l@A>]G^2<TS1Ng^2^^>:A[^3B[p_:O^40<kbNk^"
    "498pbG3^4CH>^1O^4Q<B1nS^5APY:a;^6LKeNG7^7?HEc33^83oTb53^8I:9Bjk^8TZQo;;^"
    "8cepZYO^8df7bVW^94RH:Ig^9JaJZRc^9h23N9c^:O1D1j[^:TjIBbg^:`5[>J_^;1GX66O^"
    ";@BX:MO^<0PbemW^<i3fV0o^<jJC:Rc^<lb^5ho^=4]1n=W^=O0IR;7^=QL=6=k^=_S[g;;^"
    "=boYAnO^>?pOEmo^@K?^^bc^@V<g^0k^@]B_6Bo^A55_FVk^A6>knjk^ABQdnjk^AOS9^6S^"
    "AcC5:U?^Ai6Xma_^B8ZYf=W^B@_]iB_^BVon^o7^C9ghZ1[^CJUY>6[^E0lTeS3^E6bWJeO^"
    "E9RdF:g^EaMCFCK^EnE=R73^F4DiR:[^F`Tm^bg^FcB2B5G^GIKW:J_^G^?Nn1W^G^hYe:GT"
    "H;R^^AW^HB0mB:g^I7;DbFc^IegMZMC^JZ?3fA[^K0k;[:G^K;@DN=c^K_=boGG^L1W]YmK^"
    "L^BAEPk^M<YHJE_^MahDZa?^MiVm>>_^MjGRjm7^O2jmXj3PO8M8:IW^OE;=N>W^OJ^h]ES^"
    "Q3BSZ6C^Q5Gfk5c^Q@J`n7?^QhKlG;;^R=BeRYK^RDT9]m7^Spd^NIO^S^`AbM?^TLF>aMC^"
    "UFlIJFS^UdL];13^WSMi]j7^X0<m:A[^X@iXZm7^XQVD:mo^YWF7j=K^[0N_>6?^[<h3F1O^"
    "[D5?ai7^[PeknBc^[g7_N2O^p>UXV2?^]`a[Z^c^^a]d2Z_^_9cL?:_^_P[^Yng^_ib=ZI?^"
    "`HD1RF[^`VLaEQ3^`aQh:9c^alQ=b=o^b9bTR6C^bCSTnG?^bVK;:F_^bhJ:k8k^c6a:6<k^"
    "cMMAkKK^cR39>67^cfBRalo^dKbAOGG^dLQ`B0g^dY1]ViK^e9<D1ig^e>S?9Q;^eUkGJEc^"
    "eXW1g4o^fFiY:e?^fX>Wj^c^f]VlVBk^gR_>>;;^iV[KBno^iZ7Hb2c^ib[1bA;^j6d>f6K^"
    "jJK:en3^jOEUQ=WYjbOE:aC^k1:oFRg^k<9=Eeg^k>CbR5K^khGM:IG^l:U]b=7^le@M:YC^"
    "lfi6NVS^lmF[O33^mB]5iOC^mHS8NR?^mXmF^RW^nA=7ab_^nhB:JJO^o52SFEG^oA]HZ1S^"
    "op0`>33^oaWLJ>S^00001jG^0S^0FIG^0V59:6C^0XE@R=W^0cDR6AK^0hQ9NJk^0oMmNC?^"
    "13SAN=?^15pk6BO^1<`aIiS^1>Jej9O^1HmWae_^1MBW:1c^1N?d1NO^1N[PIbW^1QnXn>S^"
    "1Tg31Uc^1W@n>YG^1]Fbj2K^1fA<MV;^1g?L2F_^1nCBEQk^2>e8:5c^2A4Ii]G^2CQ9ijO^"
    "2CcJZJk^2DY=fUG^2NiCj2K^2Wc]MV;^2dEFEb?^2l4EfA[^2lGL>9G^2m]Ij9k^2ncFVRg^"
    "31DeiJK^353Zf2O^35_Oae_^3;QNAj?^3AabQf7^3MmNV1[^3TCTf>W^3]im>I?^3_?jjU;^"
    "3cg;6Q?^3k=KnNc^42KemaW^4:nQJFW^4GJHAek^4OLN9eO^4PbKfAc^4UIp2EO^4W`db2;^"
    "4XdQ^1_^4]_`j^k^4j<e6Jc^519Y9nk^58li>9O^5APOG;?^5PG<66_^5hk7^J_^5jOJ9fC^"
    "6@Pcb5g^6D52f1O^6EK0R9K^6EO6FB_^6Id5b:O^6PToR2C^6Qjm=b?^6YBjFFS^6n37j9K^"
    "6oI5VMG^70O2BN_^75WSbIC^76_FR2K^76mQN=K^7CMN9b7^7G6VIN3[7OY:=f_^7_UXf9W^"
    "7`kVRE_^7eRf^EC^7li7ZB[^8PZOaeO^8RIEj:[^8Xg9BUC^8YLPN2W^8_KLR^_^8khPb>W^"
    "90QVm^K^9R2g^B_^9_7M^]G^9b47mbG^9jVcFJc^:3D^>=W^:7XIFG7^:G6p:QC^:G:b26W^"
    ":HAR6bo^:SVXifC^:_ZWbM7^:o^cV5O^;14a>9C^;2:]nNg^;8K2:2G^;E99ef7^;QDeinW^"
    ";pFmnIK^;g>RJ=G^;nTcF>K^;o@XAik^<=eC:IG^<Xa3FI_^=ZhafJc^=lBO2Vc^>B_E1V[^"
    ">JJ`5ak^>SlFf6K^>[BMn>7^>e0U2GG^>iHIEa[^?2`LjIC^?3fIVBW^?5Jp21c^?>]n2BK^"
    "?FBIj>_^@T<JbJ3^@U`]>>K^@ZL^nQW^@o8V2i7^A9Hp22C^AVfdFIG^A^hjB9O^AeKOAb3^"
    "Amn:^_7^BHIEFM?^BPKK>1[^Bpn9ZFk^BaeTYf?^BigZQi[^BjH@6R_^C4L8VIC^C5R5B:O^"
    "C6d:>6O^C9kfB9O^CAml:AC^CGn5V2c^CSH5Ub;^C[J;M][^CkNG>5o^D3PM5j7^DDjVQic^"
    "DLlpIi[^DT6RR]C^DVp>VBS^D^>;RY?^D`8WN:G^DnF@26S^DnTJnAK^E6M7MN3^E7ZJf1?^"
    "EP7YEMoYEXRP2=G^E`6kj5W^E`TUj5W^Eh91bAO^EnSiZ0g^EoYfFRg^F8Ga:A;^F:QJbFK^"
    "FAUA69O^FR76f5c^FS4C]NK^FY[R]aW^F^YeBNk^Fedn6Bk^Fi67Q_?^Fk5p9RG^G37b1Q_^"
    "G67d>IG^G7=`j:_^GCYWb5_^GHEYUnO^GHWjFFc^GIYa>Bk^GS]cV6O^GpX=9]o^H1;kj=S^"
    "H1o4FBS^H9h:QfO^HE@DQf?^HORBB9_^HUb>>]C^HadC::O^Hb^LjIC^HcD1bm3^Hd4JRIC^"
    "HkJ[Mj;^I01kZFW^I88c9Z;^IBJ`j9c^IL>gmig^IT@mf9K^IUVkRES^IZ>;^EO^I]Y1J5_^"
    "J1ER2N_^J5n8f2g^J=aHj5_^JEcNb5[^JSbbR5c^J`EPnFk^JgPYbS3^Jm_WJFO^JoCief3^"
    "K7cOj=G^K8iLV2_^KJ?P=i[^KJCV2Bc^KKELjW3^KNXUN>K^KUIO>:C^KbcKfI7^KiF0f9k^"
    "L2gWVAK^L5CQn>S^L:L3NI?^L;Sf>2S^L;b1:MC^L;kcNa7^L<@NbF_^LFl09bO^LHAmef?^"
    "LcOnf2C^LdJ8R9S^Le`6>EG^LknTIeS^Lm6G9^K^M1]WF>?^M8l1AQ[^M9dNab;^MUNoN5O^"
    "M[igFEK^M][XnAG^MgZ6fg3^N31=ZF[^N5F6YUk^N7YdMng^NEM=nB[^Nb1<V2_^Nc`fRAo^"
    "NfhWUfG^Ni<EN[7^NoKC2FK^O9O;RAK^OKk;f5O^OKoAZ>[^OM18RRo^OQ96>=k^ORbIV6c^"
    "OXK8UfG^P4SCB=K^P6o=VBW^P8SP65g^P>>=Z5c^PHW[ebS^PImYQf;^PJf4ejo^PJlEF:G^"
    "PZk`:Z[^PgKajA_^Pnb2e^S^Q;P:Mj;^QGbo=ng^QQMONJ[^QiEbNo3^R9EP::c^RG8iZ>_^"
    "ROP9N:o^RcphAf7^S16n^FS^SNpd>B_^SQolb:W^SgB6N:k^Sl]H:Ec^SofBYa;^T6>nj5S^"
    "T8ZiB>O^TJCGQn[^TNJLnbg^TW]D6E_^Ti7MRAO^U0M^M^S^U=;f9b3^UY0jNV?^VHdUBFo^"
    "VL7]fFK^V[[D2EC^V`UK6>K^Vo_pY^7^W2bZFFW^W:1ZJAc^WF_b66S^WM=e2po^WSMi]bC^"
    "WU?jj1W^Whmb:?3^Wnp:=ec^X>`EnAO^XFbKfEG^XKo3:Jg^XX<UAb;^XYHobMG^X`>[9mK^"
    "Y0Bfj9[^Y29J9f[^Y8Dlaag^Y:2@E>7^Y>gQab3^YI_6=io^YQa<5]c^Z3HjZAG^Z9]D^N_^"
    "Z;AW9Yk^ZJP@nVo^ZpeZ2fg^Z]Fo^AC^Zd]@Z6S^ZdkKVAO^ZfK;W0o^Zj0EaeC^ZkkZUac^"
    "ZlmQN9W^[1KHAbC^[4NF2JW^[5::m]S^[?EjNJG^[J=i_33^[NiPZEK^[SP`fEO^[ScKBe;^"
    "[^P2J=G^[iR:NEO^[jYMbC7^p7lA]U_^p<2@V:[^pMZ^fJg^pXRCB2K^paLpeb3^pk8g:5[^"
    "]3e5b2c^]60KV1c^]>pZ=jK^]@S=Mb;^]J4d=f;^]KJaij3^]Ro=aN;^]gRlR1O^]h8QNi3^"
    "]hhj>EC^^0?;9b?^^5e7:9[^^68?JM;^^;I0FJ[^^<mBe^7^^AT`bE;^^L;lZ:_^^OAFMmo^"
    "^Q3GYm_^^Y5MRIC^^ZKK>MO^^_2[J=G^^bMQ65_^^fHlB>[^_373mnS^_6:1^JW^_BUhUmg^"
    "_JWnN5S^_Kml:=c^_k=f:EG^_lE9NO7^`2T76BG^`48IQi[^`6LXVF[^`OFJN>S^`[SlUb?^"
    "`kjI62W^`l4HR63^a5PaN:[^a;pD61o^a?@S:AC^a@VPf=G^aB>i5f;^aGlab6?^aK`Of2G^"
    "aTZiIV;^aUe;nJW^a^lg::7^ai>X>5O^ajTUjMC^b0c469G^b1jfenG^b=4p2F_^b>XnMak^"
    "bC=KZ^g^bZCO:5[^bp76fEW^b`^G2AO^beEW>=K^bh4WnFc^c4b_Z:[^c<ND:O3^cKf05^K^"
    "cZBmf5c^ck]7AbK^dQ26::O^dRZX:^c^dU8`b>[^dZBn2]?^d]?XAjK^d]o[b=o^dcN6N67^"
    "e1XSjAc^e7<M5nW^e8do62c^e9Gbj9O^e=Gob1k^e>F[VFO^eCjTab7^eF[A^:O^eIXMI]g^"
    "eK4c>2;^eNb9=b7^eVFU5^C^eZf8:IG^eb<I2>[^ejjCj=S^el@AVMC^f3VRN2O^f>`G^F_^"
    "f?L<YU_^f@DZ9b3^fg1Bj=G^fi`CZ:_^g6NKB6K^g>9of>g^hR]ab6O^hWlW>F_^h^kCifG^"
    "he9b66S^i8h8anS^i;3NUmS^iEV@Mao^iKD95ek^iO7g::K^iX2@]fW^ipQcbAK^ich4^>_^"
    "ig`VB:[^imkm>EG^j@L3FJc^jB0Eef7^j]eJ6ES^jkKoAj[^k8:6mnG^k`Oc^EO^l0@i6I[^"
    "l4T<Eb7^l::8FJW^lFh?n5k^lR2D^MC^lTIMN6G^lZ4JV9O^l`DOAmo^lfeMb6c^m1gUfA;^"
    "m3PYie[^m:SdMnK^m?bYfN[^mCTeZEK^mGAl5ak^mKVkR9W^mLodab_^mPcRf:G^m]14mb3^"
    "m^=ONEO^me3:f5W^meS`JJ_^moWXjAO^n57FV=O^n=9LMiW^nB7_2Rg^nE]2Vfk^nNSUif7^"
    "nVU[aY[^nfYgR5k^njHZ>AG^nm7Zn>c^nn[mIn3^o35BBjk^o@66eac^oH8<^9[^oLAbj5W^"
    "oRWi>6W^oVS`ZIg^o`g2>UG^ob;OJEG^ocAhF:W^oi_kBMC^00001b7^08K8^E_^0FQ]9Bg^"
    "0O6>W77^0`aG6RS^1X0SJ2K^1`[3RQ?^28?3YmK^2>:jEjO^2LA=JA_^2SWWmnS^2c9Z:JK^"
    "2j9E6F[^35K7^N[^35mU2:;^3;]nnY_^3B[p]ik^3Q3>JZg^3e5=^A?^49Q8MbS^4@lej0_^"
    "4EBgJES^4Vjk6Ec^4iO4jM?^561;ij3^5NpC2AS^5O=ibIK^5YIQb^c^5`SAUf;^5e^0:9[^"
    "5hZ95^3^5mAIB2G^62mFR>[^6P7Abjk^6SE:m^7^6XVNbI[^6]8`JF_^6eiDaag^7@l]:J_^"
    "7BE9iFc^7Ofp:MO^82C6EmO^8^F@J2?^8lLSNAk^90ZXV7C^9;aGjB[^9IPl^>g^9UVMb:S^"
    "9elafR_^9n]F9fC^:1>TNFW^:>O9N5k^:BS5^AS^:E?3F]3^:WkHb9o^:^[BZAC^:hpYVbk^"
    ";1GX66C^;>jLaiS^;Um0Qj;^;V<QmM7^<<7GMj3^<DUIFBW^<EiF>9[^<HeO9M_^<RDn:Fg^"
    "<dm=aZC^<n`cBNc^=3GTf6G^=8adfEW^=Zhaf>S^=a83>NS^=gViMj;^>022>IG^>Y_Jj9k^"
    "?K?^9n;^?LWiR=g^?[8oRFc^@5acf2G^@7TdZN_^@A]lbFO^@DBlFB3^@K:KZa3^@QIjRFO^"
    "@]_;Z5k^@b^KbAS^@jPbjEO^@m21>BG^AFZkEaS^ASW@62K^Aemc2>S^B3lO>0c^B68FR2?^"
    "B6bo6JW^BCXp:Fc^BT;f69_^Bcm0nN_^Be?o>:S^Bi0e=]c^Bi[M^2_^CAJC>I[^CDXkim[^"
    "CXm:jI_^CYVhF=K^C`A2Uf7^D;i9Amg^D>=lb>[^DP=HBEO^DVp>VFS^DcJF>1_^E9j`nAg^"
    "E<fUQic^ES==YjW^ET;]FJ[^Ela2JF[^Elc?VAk^EmVkVA[^FI?2BE[^FUm9jBS^Fp@1:A_^"
    "FbJiamc^FcZSmj;^G1U@VFK^GpD19j_^GpF19mS^HORBB=K^HVCpUU?^IBJ`jIS^IF@2F9[^"
    "II<;ALg^IR9LnE?^IXZaFEK^I^2gW:K^IkUpB5K^IlNUIn7^J3^@mjO^J98PnEW^J@LHYag^"
    "JBl<^N_^JVlO2BS^K0H^FAS^K7pV1f3^K=6f2:W^KZ672=c^K_=bmik^LLnUZEo^L]Nl9hk^"
    "M5=S:>W^M5BVanK^M68OnB[^MGM1>@_^MK`>6Rk^M[Gj9n[^N<kBn:_^OeV[F>G^OfKHJ9S^"
    "P2Dc2AK^P@J52fK^PG;OFA_^PJlEFJ_^PYCg2AO^P`W^]j3^Q<?eIiW^Q>_YNc3^QE_DJBc^"
    "QPT4JAS^QUp4]mW^QWCnBUK^R:AM6A_^RTRIJJS^Rm9k^F;^SJd7:6_^SdJ96EO^T4oQ2R[^"
    "TNSEbF_^TTMMb:[^TZB;5ao^ThHN:NW^U8^_^J_^UAOD1V3^USjjYnc^V;DkbAg^VI1@YaO^"
    "VMi5Z9O^V`UK6:[^Vm;mBB[^W44m5MC^W9O=6AG^W:1ZJMO^W@aTBES^W@c4aU;^WDf]1n?^"
    "WF_b5jW^WPGpB>[^WSMi]^7^WWC;:>O^WWGG>>_^WpK;N9S^X0_JNAO^X5gJb1W^X7ODFQW^"
    "X83B9e[^X=MR6>[^XARa:Nc^XJCEMRC^XZLc:AS^Y4]_NBS^YMEAb9o^YV]72M?^ZDUO:IS^"
    "ZPNUN4g^Z`;HZB[^ZmjmJBg^[JFbRNc^[S7FiWK^[gl`eR;^[iY421[^pO`GJAK^pfb4R9W^"
    "pi<V^1O^]70c6FO^]OT9F]C^]YZS:AK^]i0HZAG^^6^nfJg^^7NQ>BS^^IG>MfO^^J91f4c^"
    "^OAFN1k^^Pj`REG^^S:cnN[^^]Xh:6S^^^;ES6[^^ea8R=W^_:X9>=O^_KmJV?;^_Ti5RBO^"
    "`0Q<>R[^`DS;V9W^`RHnFN_^`bV[6>S^`d`e>]?^`l4HR=O^a8SEF6c^a?S0BFg^aZDc9=_^"
    "a[neJNW^a^lg:A_^aoTLFYC^b6@mj5g^b:TmgKK^bH86iYo^c81@b7;^cKSd:9W^cNBCBRS^"
    "d9ei>EO^dAGF^33^dHG1ZFg^dWYgB:O^dedCnMW^e166VAW^e8In=Y7^e=d>>2O^e>F[VB_^"
    "e?@SAjC^eK4c=nC^eWM8EaC^eZcOB9W^ebWmN2O^f54KVRc^fPpRBR[^fQLgFFc^fcknFe?^"
    "fd^QZ9W^gDl;BMO^gQ;36F_^ghlH5bO^h5ZOa^3^hH4TYj7^hZSZfRg^heGD2AS^hgNKV>O^"
    "i1@^ZEc^i@^1f:[^iML9Mnc^iX?bZA[^ig6Uj?C^jja^^A?^k7e=FNc^kPhV62C^kQALZES^"
    "k]oTB:W^kcGpAjo^kgF=JJ_^l4=Jn0k^l::8FR_^l:neF=W^lFh?n5S^lU?aZJW^lV@:j;?^"
    "l`DOAe[^m0ghF^o^m=][]b;^mDigZ=S^mW9k1bC^mbmG=nC^n7bFF9g^n>S`Ye[^nI7^9Z;^"
    "nUeeeYk^nYpWQnO^n]V52FW^no2S^AK^o=7QF6S^oERZ6=S^oFUgR9G^oHNc1V3^oI^3VR_^"
    "oJcVQbG^oTCe2^_^oVS`ZIW^oaECZ>_^ocAhEjK^0O;B?3;^0[iIji3^0n;g2M?^1GX6E^?^"
    "1h>7g37^1mbMBFc^24l?Nm3^26FnbAO^2:PTn6[^2AZG:Po^2Oc>5jG^2i?MJIO^3FeBj^_^"
    "3Mo56pk^3SSJVNg^3`AR>9S^3gKDIMk^49]aQec^4ZCc2W3^53`2FXo^5@N:1ZK^5M<AYN3^"
    "5l<fNB_^63FXZ[C^6f?7AbK^7Jn^o7?^8?Alimg^90_p?3;^9=Mcjhk^9O`A2EC^9Vj3=5k]"
    "9e2j:=S^9i<PE^?^:1a1bN_^:IbQfZk^:OFgFB[^:VPYR];^:p4nn2S^:c>a:A7^;oSO6Lo^"
    "<3]5B^g^<57dVJ[^<Ael>9W^<Ho^IUk^<M9DVXo^<YgLAJK^<fUSiFK^=4^Jf6O^=;h=2Nk^"
    "=UDLJY7^=b2T1^O^=n`[]V7^>Tk2ZWC^>llR^lk^?;5IYaW^?GcQAnG^?lS8no;^@9A@ZK7^"
    "@mTNR6S^A:BV=f7^ARD6Bg;^A_2=j]3^B1D[2AK^B8NM=M_^BJ`jEfC^C0kAF>W^C853RIK^"
    "C=YHmnG^CDc;:=C^DQ7i6M3^DUAOFc3^DjT8M]g^Dn]^ZY7^E;KfAVO^EH9mmFG^E]LW6F_^"
    "F6hfJQC^FCVn1bO^FPE5]Z7^G6OLZS;^GNPl^lk^Ggm<0moXGiGkAnO^H662n5_^HN7S2_7^"
    "HZeZZ>o^J3hPB_7^J@VWjQ7^JRi52=O^JZ2g=Uc^KEaSZA_^KYYMRA_^KfGU>5O^LCmJ]Eo^"
    "M2pC:E;^M6eiFRc^ML8RMag^MPB8ZIC^M]0@A^G^Mi^GmN?^N?116BW^NXM@JIK^Ne;H1jO^"
    "O1iO]b7^OVY7JZg^P05F^Xo^PIQV1JC^Po[m2S3^Q<J4Z:g^QMAbR^g^QYoj:a?^R3L9MEg^"
    "RAU0J=g^RNC86FW^RULjB_7^Rb;1jI?^S;WAA]_^S?`gN=?^T;=gR=k^TGko>1[^TeQd]Ug^"
    "UT@]:E?^UXJCFJc^UmplMig^V1fRZMG^V>TZAbC^VG9;b1W^VKBamV7^X8=QJJ[^XI5?Bc3^"
    "XQY`^Q;^XUcFj;3^Xk601VC^YJ6Tf6O^YQ@G2Jo^YVdpMf;^Y]nNZ6[^Ynf<R^o^Z;TD>U?^"
    "ZU0SQMk^[71DBVk^[C_KnAK^[];[Aac^[aEAN5K^[hO3Y23^piPI=mc^pmYoJMC^]G6>]]o^"
    "]OZ`:?""?^]gp@>Zk^^9n]FBW^^SJlZIK^^`94EjG^^lg;m^7^_k32n]7^`RX9>1k^`YakJBS^"
    "`jYYBW3^a3>:bI?^a7G`n6k^aLZJ5^G^b2da2Fg^b?Rh^2O^bPJVRW3^b]8^>EG^c6TmQYg^"
    "cW:o33;^cXU^BNc^ceCen=S^d0W>Flk^d=EF1:C^d>`5Aec^dBi[N1S^dJ3MY9k^dX<DV6S^"
    "e0=d[;G^eO>IJIG^eVH;UE[^ec6CARS^ehZX]ag^fI@Z>F[^f[S7F>S^g4oFZAO^g<98eak^"
    "gA]NEjG^gNKUmb;^hLWM2U7^hf3pEJG^iL>3BJ_^iTbTbEG^iXl:n2_^in>d5fG^jTI;2F_^"
    "ja7B^2K^je@hjbk^k1o0RVo^k>]8>EK^kEfjI9k^kX9GQ]k^l8_I2g3^lR;XF`k^l^i`1NK^"
    "ldN5Mm[^lkWgYB3^mQb>ZgC^nDZ]A^K^nc[B21c^nje4>FK^o]]Rieg^00002:7^0;jUV23^"
    "0m6a>Mk^1@Y1V=o^1eN6NAg^2=F=ER3^2C9:V:G^2OO7Af7^2[Ipeio^39M<Ej;^3>gnU^;^"
    "3B[p]Qk^3IYHN>3^3JbT=^7^3OIdIU_^3p7l1Uo^3hf3]f;^3i0o^Io^4c><V>3^4f7`jJ3^"
    "59Z1BEk^5M<AZR3^5XlCUik^5`@h25k^6=PeI][^6HE:mio^6J>m623^6ZN4ij7^6fHZN63^"
    "6kcL]ZC^77^2Eek^7BZH:=o^7DL9nB7^7b1oJMo^7l[HnJ;^92[12V3^99m<9nK^9Ega]]k^"
    "9F=AJN3^9ckA>27^:>O9MF?[:@JNB>;^:GIS1Z7^:K=A9J;^:SD8Ub;^:WkHaQ_^:dYPMYo^"
    ";1GX5f;^;O=XB:7^;[2o:Ug^<hbLJ5k^<kp0^Z?^=?>A6R3^=Dl9ab7^=F2IeUk^=Pf_Img^"
    "=R`QNN3^=boYAj;^=nj>in7^>4E19Z?^>@?V]^3^>H:I>>?^>Lm^In7^?H>WnEo^?T3nfIo^"
    "?gV?>9g^@BN`Uj;^@NIF9]o^@lLeYj7^A8?@fF3^AG0]eF?ZAKaQ>Io^AOk7Ib3^AS^eQNC^"
    "A[e]1jC^A`Lm=Qg^Am;4eYg^B9i<Qf;^BT]YBFG^C@;jn:7^CKklj5c^D;DdAm[^DAefUZ;^"
    "DMM^=j?^DNSn=V7^DYHCab7^E1@@RB7^E7KcAb;^E<fUQV?^EDbPjMo^EHa;9b;^GVjjQj7^"
    "Gm:O25g^H:I<Emo^HFCaifC^HORBAN7^HXL[ej3^Hp@ImJ7^HdGAIf;^HhnQUMk^I5pYAYc^"
    "I=cPVAo^IBJ`ij3^IIXgNI_^IQE`n:3^I];7f9c^Jmd9N:3^KCfHYYc^KJGJmV;^KUoBUn?^"
    "KW5RYZ3^Kaih=f;^L>I5>23^L?mG]b;^LEH9m^;^LQB_Qb?^M6dPF23^MJF`^9k^MV<7VI_^"
    "Mi^GnJ3^N_LNmj3^Nfe9:Qk^O:GIR9o^OBj`^67^ONeFEf3^OX3fYJC[O`n@>B7^OdanER?^"
    "Olhef23^P1P61Mk^P>>=Yb7^PJlEFB3^QCG`JEo^Qb_GZEk^R@MGQn;^RLGm5]o^RRhoI]_^"
    "R_W71^7^RjKLUn7^S3HIBIg^SFjYZB3^SMi^EfC^SYdCmfC^TCmE223^UOk0R:3^U[`GJIk^"
    "UoBWbEo^V9CK=b;^VWFj]n3^V`UK5Io[VmCRaN3^W5JJ>67^W:1ZIUo^W?kYFIo^WF_b5^;^"
    "WSMi^:3^Wd`^>A[^X5EQ2>;^YHl0>Io^YHnkif;^YTaG6Ik^YTiQMb3^Y[JSaY_^Yh8[Mf?^"
    "YhCWN=g^Z2m11j;^ZDBHeb3^ZVKBaf?^ZbEhEb?^[8lY2N3^[LNiJV3^pFp6F>;^pIQTf67^"
    "pRL8Aig^]AdoUao^]C^a^5o^]SmiQj;^]_hO9mk^]aDW:Ik^]i6oMMo^^5e79R7^^=knYj7^"
    "^BS>eMk^^OAFM^;^^^GBV1c^_1k?Qio^_1mXbR;^_EOi:N3^`?GVIUk^`Fp:afC^`NL1>>?^"
    "`]K5j27^`cl8=Ug^a0Z?en7^aLcmAnC^aNP@2:7^aZEVjEk^a^9E5V7^a^lg9n?^ajgLab?^"
    "bjnXNR?^c>PhfJ3^cR39>>3^d>KnMb7^dJFT1ao^dL@F:63^dpOMmj;^dhJ3Qb;^dmdea^G^"
    "e1XSiR7]e9_KIb3^e>F[UR3^eFMS1b7^eGQ?^Eo^eK4c=Qo^eWbjif?^efhfn5g^g7QhVJ7^"
    "gCG?NIO^gGi:aZ;^gK48n=o^gViOf9_^gelZAj;^glMpU]_^h9;dAf3^hIJl5mo^hUEQYf;^"
    "hZ`CiVG^hfZiQ]k^hgNKV:3^hgRQJB3^i3I19j7^jEKaV5g^k0RhBB7^k4dXi][^kD58ZEo^"
    "kFmRej7^kRh8Ib7^kcL_j9k^l0kWmj;^l6FJ=^?^l::8EMo^lB@oab7^lFh?mMk^lSVGYMk^"
    "l`DOAb;^l`OKAik^l`SQ:J3^m45aR9o^nDZ]B63^nPJ_=j3^o4oA1Yc^o=68FJ3^o?cVUb3^"
    "oA]HYio^oPXH^:7^oQlPN23^opM_VEg^o]g65j3^ocAhEVG^oo<Miec^00001fG^05^ZJUK^"
    "08:inZ_^0NVO>IO^13c?nNW^17TDEQc]1@Y1V1k^1]:@f];^1ac9EB[^1bCIbY3^1bPXj6;^"
    "1c;J>RW^26VP:]C^2=DXZa7^2SjBNR_^2V<MNQO^2^;VMY_^2aZ1ZY?^2k9BZV[^3AG;9Qk^"
    "3B[p^6G^3J]bZZg^3LAEjNW^3_m35Uc^406=fYC^40Dkaa[^47M5RYC^4Ba<fEG^4K:TVN[^"
    "4]bK^a;^4`7YjQS^4fhaAn;^4hRgYZ?^56Z@RQO^5:R^jg7^5@B1^QK^5@^]]V;^5M<AYmo^"
    "5O3jIB3^5UZ;R9_^5e_IRRW^5fUo:E[^5gGD]a[^5o3i1f?^61OFAI_^677aVEO^6@?9QV3^"
    "6F54>QC^6JG;6AK^6X^OaN3Y6c>ojIG^76T7R9G^7@pNJVW^7bQi>NS^7bUWbIO^816T:6C^"
    "8Aai^BW^8B2GbC;^8WUTZMO^8Y]7IEg^8jdn:AO^9CpbnAO^9Ef=6a?^9EfU]nS^9UpCRMK^"
    "9]LHfMC^9^FXj^c^9j;V2]?^9kCTjbg^:05dMR3^:3Zg6V[^:7Uf^IO^:TbjFJ[^:__VnRW^"
    ":k5Q=fS^;83G^IO^;8Wb>YC^;9RR6RW^;9i=jRW^;>oWJFW^;F@Y^Zc^;JbPe>W^;KBa>MG^"
    ";Y9>FJW^;d:V2=O^;hY>BUO^<HcV6]?^<ko7abG^<n@mnZ[^=5laf>W^=7QGUmg^=?oAJ9g^"
    "=GM95V3^=pMdZVk^=kV`Ii[^=k`TFQK^=l:>nJS^=n`[]mk^>76kVR[^>7>UR:S^>?pOFEg^"
    ">H:I=n7^>IianMO^>Pif^R[^>VFl6J_^>p`emR;^>gc=J>W^>i^5=Z?^>k3MZRW^?^RBU]W^"
    "?`792MS^?`[=6RW^?b>[aR3^?i>Q1Z7^?n=IZ]C^@3FRVEO^@:@;en7^@=iDN^c^@J=4F6S^"
    "@L>GJIK^@[8gn7;^@^dM]Uc^@`C_9U_^A;V]f4c^A<<KN^_^ATonB]?^A]NE>=[^AhA;FN[^"
    "Am^@^JW^B@Tl6MO^BA9FZ];^BB46Nbg^BGQ;fJ[^BSdEZMO^BaD6nF_^BaZbbFW^Be?KZ5?^"
    "Blp:NEO^Bm0pnNW^C1:b^QO^C@1B69S^CF7BfFS^CQE:RYC^CeHbfRW^Cgnj:>[^D6;bE]c^"
    "D6bRF^c^D>NFBFW^DIS3F5O^Da2_>IO^E3ahEBG^E4B8^MO^E4[cJRW^EH9mnF7^EM9mRAO^"
    "EQ_W>VW^EYKK:V_^E^hPNN[^EaS[N>S^F3U22NW^F8[KV_7^F927JFW^Fa@iEn?^FhX]NMO^"
    "G:ZVf9k^GFJhjbc^GT_kbIS^GViEj]C^GbjNJ^c^Gh53NAO^GoXV2J[^H0EU>]?^H:hBIJ;^"
    "I0b_b^_^I4?H:7G^IE;;f6[^II6PRIO^IJNYNAO^IJUZjg3^IJlF^RW^IP2`>Nc^IR=hM^?^"
    "IpEj2IS^I];7en3^Ij<G:>S^Ik=KbUO^Ima05Q[^J5=^f=W^J9pG6UG^J>eP2Y7^J?2_=nC^"
    "JS8VJUO^JYf^jUG^J[F5MIo^JmjG>RW^K_=bn6_^L<c]:MO^L==GbV_^LLXD6QK^L^hn]YW^"
    "L_CC6IK^LbC[FRW^Lbl3]N7^LgJ4jR[^Li0YV=[^LofdV>K^M;chQJ3^MAS[fF[^MQ^KjB[^"
    "MW4e:fg^MYeUAZ;^MYnIN6g^M`ZKAUo^MkV0]JG^N1:AfUG^N2<Ab5g^N2RJbAK^N4bfAJC^"
    "NJ26ZIS^NKUoAfG^NNlMBZ[^NV4[IV7^Npa?aJG^O1iO^9c^O69E2EO^O8::NFS^O:GIQj?^"
    "O?a6:MK^OCIfaV;^Op?0j5k^PS0=fEO^PS7?Bfo^PSMk6NS^PXTDZJ[^Q2G?bB[^Q2]kUnO^"
    "Q6BTMQW^Q<J4Z2W^Q=l5JYG^QO:IB5S^Q^Ap2BO^QbHCFQK^R2>Ib=O^RAOS2Fc^RGe[:V[^"
    "RXg0nRW^S3N0nAS^S:`SnMS^S;=?m^;^SEEARQO^SU9hNUO^S^IhNQO^Sbb`2VW^SgdgRMK^"
    "SjNSnZg^Sje?^NS^SkMX9]_^SokYBRW^TDELmV;^TJ5@>FS^T]S^>QK^TbOmiVW^U;3o>A[^"
    "U<:36A7^U=DJYNC^U[>G2QO^UfO96MO^V3EgBJ_^V7>:Z=O^V@[^fZ_^VKkK=Yg^VS`[b:S^"
    "Vp>UZ9c^VdpOMjC^Vdc@1Qo[WSMi]^;^WU[FBbk^W[QbBES^W[Xc^bk^W[paU^3^W[oORV[^"
    "WaLTfNW^X:=nF6S^X;?On6S^X;p:6QO^XE`WANC^XFMYbUG^XFll:MS^XJ_OjUK^XSQG^E;^"
    "XVbB6:G^XW[m^AS^X]N>=Yc^Xf_:Un_^XlI>AV?^YEA35M[^YW]=f:K^Y_?ZeU[^YfLHRGG^"
    "Z699Ffo^Z7H<:NW^ZNW<JZ_^Z][LjYG^Z^V<bZ[^Za17IEg^ZfkLfQS^ZgJ_>MS^[3Fd:RS^"
    "[89`b=S^[8M=^NW^[AaQn5G^[RVdZBS^[k1RAVK^p9JgEl_^pCUSVQK^pJFZmmo^pc_kN]?^"
    "pd<WMZ?^]GI?nQS^]I=CB^c^]TLoUQo^^d:H6^g^^dQ3jRW^^in9BNW^_D=^RUK^_ONPRYK^"
    "_i8NV>[^_jXbnBW^`3KL:QK^`4jb]a[^`?LTZZ[^`Ga<:bo^`Lg[NQO^`WJHYJC^`WjY5E_^"
    "aW8`b^g^ad[QVUK^ag0_^=S^ag7a:fg^an_naRG^aoM1BUO^aolCZIS^bAEMjRW^bJC6EUW^"
    "bUHUaYk^bn@JUMg^c7h;]Nc^c@pUEjS^cB07VBW^cL782]G^cNGSMNC^cQ@@n9K^clAOfe7^"
    "cnPDB]C^dE9DZMS^dPJ6^MO^dQ^gZ^c^dp3M]]c^dcM;:9_^e?N:1JO^eFWl>9c^eLHjf>S^"
    "eO4Z61k^eXEneBC^e]djEMk^ecihUEW^em2XFRW^f4>PV=;^f6POb:g^f=pc]JK^fKA7:F_^"
    "fL_BjYG^fM;ni^C^f_VFmUc^feW7^MS^fiOV6FW^g=LG5a_^gNKUn=k^g`L=MM[^h8a7:23^"
    "h9D2B9K^h_4WVA_^h_ZE>fk^hm=5nUK^hoYEV^c^i8Mh2a;^i;A==MW^i@l>jES^iU48EMk^"
    "iXl:n2W^ing3MAc^j0`SZRg^j:cbBF[^jTXpJa?^jiU<RJW^k4c4Ba7^kKLcjBS^kMZi6QK^"
    "kW_F=N;]kXk[6MS^kZ@L6fk^l>Gm=ac^lB<>>^g^lRXQeQ_^lW?b1R3^lkWgZ5_^m45aR5c^"
    "m54p]n?^m5=PjZc^m:?XJAO^m?249VO^mBY0>RS^mE1U::G^mMOO2=g^mU9^b5[^mU@gFUK^"
    "m`1C=Ek^mai0ZBS^mn8p:QO^n21:NJW^n]=e:R[^nnV=:IO^oAEFA:;[oX03n6S^oiofQY_^"
    "000022;^05pWQMk^0EG7Z9[^0FJ;AEW]0pm2BQG^0^=lER;^16IAVQO^16iXZ:?^1@3V9:G^"
    "1CdC:RW^1F_A5RW^1TFZUF;^1lWjJZ[^2;p8QY_^2M3oJNS^36C6jJW^3G4K>AS^3ZfCZ=K^"
    "3_RENMS^4G2cF=c^4H3Z>QS^4PMen9S^4SDImF7[50TnnMS^5>16RA[^5OK[>IO^5Q`K=6[^"
    "5VbFmj3^5X_fNV_^62<5bRW^6:A_mJC^6bc4]6C^6nf@RVW^7KDIMRO^7RB9EM_^7eNV^UG^"
    "7hJTN6S^83e^A>C^8<mLV5W^8U^]5j3^8pG31Bc^8`>XUQg^8aO_N2S^8jaMVIO^8nOmU^K^"
    "9:@on>c^9DhGaZW^9UUSbRW^9XN2Z:;^9XkmJNO^9mIpQJW^:Q?h]Ig^:hKobUK^;>9XNBW^"
    ";_<H1Ig^;_[5F9S^<H<J61S^<WipfNS^<Yh=jRW^<`mZQJ;Z<aAJfR[^<ibMYAop=0;Y>2G^"
    "=@NTJIO^=AHMf1W^=INoEMo]>20D5IgZ>@RZbRW^>ZQXeN3]>^:7IF3Z>n0;6US^?53kjQO^"
    "?AYSUAo^?C2mUYo^?d>cjRW^?kTBEMo^@3C22UG^@CLmFNW^@T5W5Qo^A1gDj6[^A<VkiZS^"
    "A[eIn>_^A]7faJ3^AaA<:5_^Am>mQ^K^B3@Aj6W^B9m5>NS^B:2LZ6?^BDj;BNW^BF[<fNc^"
    "BRc]9nK^BXKd=mW^Bk4F1Io^CUJ0BMS^CcaZfRS^CiboBRW^CkTX:RW^D=kE2IS^DC?>VR[^"
    "DD1R1m_^Dp5V9E_]D`=RB=O^DfLYbMS^E3S0R:W^EECF2IO^EGX619c^ENmnRMS^EQ`3=nG^"
    "Eblgf1c^Ede161O^Ej25MF7]EmdZbEO^F09JaJg^FTOHb6S^FXZ_Q:?^Fb_JBNS^Ff6e6QO^"
    "G;dVJQK^G?eYFMW^GA<4A:S^Gi]I5>S^Gol8ZRW^HR>]eF_^HhodeIg^I5`QmV;^I:`2UVW^"
    "IO<aBN[^ISK^j>O^IVVURRW^IcAGEBo^IdXSN5K^JBeV>=o^JJlA:VW^JNBZbFW^JV;4NFO^"
    "J[VfZ5c^K4H79j7^KUR`:5S^KgmT=F3]L>44j5S^LVeEEEoXM5j3MJ7]M6F?>QO^M<F:6U?^"
    "M?3CjQO^MXOS>QO^MZS<b5c^MZn62VW^MggniQk^MnWHBNO^N3DMAb;^N=9_M=g^N?5OZ>o^"
    "NDF:fQK^NDQAf9[^NHG=bUK^NN:4V1W^NPICYN7pNQFgMF7]NWf`62?^NfkCUAo[NjkV^QO^"
    "O8jXIMo^OAXRjVW^OaKm9R;^P4gbeEk]P6;IMEkYP>B6EZK^PImAiMo^PW^EZN_^PmU7^NS^"
    "Q2NV]N;]R4b>>JS^R:f86V[^RF<mR9c^RGT?^Vc^S3eRAJ3^SF03JRW^SKA[6MS^T3bofMS^"
    "TTBonUG^TUanVRW^TpDDV9S^TlZPBRW^U;;0fMO^U=O`eJC^UDeYFQS^UcpEVIO^Uf15U>_^"
    "UfCnRMO^UmFn6ES^V2cAYEkZVGhY9l_^VHkpb6W^VNRJEQO^VQOE1n;^W73_567YW9K:6:O^"
    "W@_`iB3pWSMi]j3^WWX<b2?^W^;YiJG^W_U3iF3^X9M5^JO^XH6HY>?^XOe8BMK^XcQOeF7W"
    "Y0W]INS^Y1a11AoZY=CbVV_^YP5d:Zg^YY929>7^Z8GP>Fg^Z?]PAEg]ZWpMZRW^Zc=C:R_^"
    "ZoEcInK^[54KNRS^[8Je:NS^[?`9AM[^[@RWn5o^[CHE6UK^[YChN>?^[pdTJYG^p3k_^5S^"
    "ppM4N5S^pl=j2QO^]5>DmN;]]>[?]F3^]T_>bIO^]]_Y]Uc^^>iMUnW^^F@nMR7]^`Wp2NW^"
    "^`cARMO^^haNNJW^^nbC=Mo]_11O66[^_B>CZ=[^_WCWmN3^_`KFF9c^`6LDZ6C^`9<Vf1g^"
    "`=Xo5AkY`?dl]N3^`B^K2VW^`QmgAV7^`XWHRV_^`hFAQRC^aKUNEAkXaPgVAJ7XbA:Yb=;^"
    "bKiiNU?^b_GpN5[^beF8bUG^c2]:^>W^c88lmmk^c<V^ME_^cA9EjAS^cPj=IbC^cp[?b:g^"
    "c]jh2MO^cb7229_^ciZZZMS^d:hBN:C^dJS=]M[^dR;oJ=S^dSYRn6O^e12[ZIS^e3GKYO7^"
    "eC@RVJS^eYT0JEO^e[h`I>[^em`HJVW^f;TMeJ7^fDJ59^[^fY2U]Eo^flkIi>CZfmhm]:K^"
    "gGp]ZV[^gIPm9F3pgUL^]R?^ga8lnV_^gcb]Z5c^h=n3MBS^hR]O]2G^hUE>VBO^hfOH=Fc^"
    "hkMINJW^i4@KnRW^iO0pmR;^iTKMjUK^img]>QK^jHNpQF?]k3:T5Q_^k<:=b5o^kVK;aEW]"
    "kXbEbVW^kicJR5S^kmaRNNW^l>?Yb6?^lC[L2A[^lW0jB:S^lb5TfQO^lk5oaNG]m5=ln2?^"
    "mGLKiQC^mJViVIO^mSWDQN7^n<8YAZG^nP>B2R[^nUHk9QW^nVZlFQS^ndYn1MopniZQFV_^"
    "oM;BaZ?^oN6?nNS^01<BARC^04C_Uf?^082cbES^0=jImZG^0=mOenO^0?H?6F[^0FgiIj3^"
    "0LYN:N[^0ZjVBJ_^0bACVAg^0cC^QYc^0d7fafC^0jf>a]W^0jfPfN[^0jkBJE_^0kADe^C^"
    "0l]429o^0oRRVAW^188UnEK^1>F6F6W^1AnK>5W^1D3C=]c^1Dh[FF_^1E`Jnno^1I3SRVc^"
    "1VhMmYo^1Z2_5b3^1`;Mj5[^1bPXif7^1c5^1f7^1d<Pf6K^1e9<FBc^1eefjjk^1k`RnEk^"
    "1o^P2o3^22JKJ>c^25jV^=O^27_<>2o^299kREW^2;jFIbG^2?lG9RK^2@UR5Yk^2@Van=O^"
    "2CF?2FK^2DH@A^?^2Ihd6JW^2JV2^E[^2K[oJ^o^2L0=jV[^2Lf:5bK^2PWN6BO^2W:36Fc^"
    "2[44Yn?^2pH<AUk^2]iS=e7^2f:Qj>G^2jWZfJc^2n]aIQc^35G5b>W^39H8^>W^3>cXiRK^"
    "3CJi5jS^3CX=jZ_^3C`GN:C^3DhenMG^3FkFNBW^3H>>BVc^3HdKQi_^3KWHB=S^3P90]^K^"
    "3Pb1f5[^3Q1VNBG^3^jhb=[^3_RO]jO^3c]Yj:O^3e8I:ZG^3fI1:=g^3fnlJ1S^3kY0JF[^"
    "3mVBnZg^3nfk2IO^41a;:N[^42BDbIO^47aDUiK^48G861k^49[?^AO^4:o[R:K^4;4M6=o^"
    "4<HTbQ?^4CZPNAW^4JP_j:K^4TDWIU[^4YAOb=o^4a_IZI_^4cI1b]G^4fFYf9o^4npJ:]C^"
    "50[6j2S^52[i6bg^5?gZ^NW^5B`Xj=?^5H`HUJ;^5J3nB]C^5LiLfQG^5NQ[B9W^5O?UYjk^"
    "5QKkJFS^5S3Cb2S^5pYn:V_^5]MP>N_^5^4]JVW^5bA[R4_^5b`_>IK^5cP=VYO^5l^]nAO^"
    "5o3i1f3P61R39mS^65<Wf9O^65Y7RIK^67Qbe^7^69=ZanW^6BdE:FW^6EP@N>c^6E]UEnW^"
    "6GKUFBW^6Jk`ZAW^6VL4:Fc^6XGHn:W^6XMJJIS^6ZNbbN[^6_W<VMK^6c]C::?^6h5b>2O^"
    "70Sp2:[^76TKZJ[^7=GgBUC^7=d?BIO^7Eea6]3^7L<e=Ug^7XL32BO^7Y2@Aeg^7ZQa6BO^"
    "7[lPJB[^7]8XeUk^7]c3Z5g^7_E6AjO^7_kCRBW^7`XR:AO^7ec;b=W^7n8l6=[^816T9f;^"
    "83l:ImS^89TMn1g^8:9S6FO^8>eTfEK^8?0@=Yk^8BR[EfC^8BdH2IO^8DN0:5S^8EOMAb?^"
    "8N4ZQN3^8Nc1B33^8P5W2Eg^8X[ZJIS^8Y_O2UC^8]j?MmS^8`lY6BW^8gPieUS^8n=h:N[^"
    "91c[=Ak^9A0?21o^9C]T6aC^9Ce]VEg^9DGe1^?^9LJjfN[^9LOpJEC^9Le^ebC^9Q6lVAc^"
    "9YponEK^9ZLNEig^9p_QB>O^9]9cJMC^9_jPF:K^9cRe>9O^:0SEEfK^:;W95f;^:=C122W^"
    ":A_gj5_^:F]VJB_^:R@eJ>c^:U0fUf?^:WO0bAK^:Y2gEN[^:YCV>;7^:ZQJJJS^:Z^ER=S^"
    ":]N`MbK^:dbORZg^:djY6>K^:elZA^C^:l:L^EW^;1PW>JW^;2;h6BS^;5NpN5[^;8D;24c^"
    ";8^M66O^;?FGaV3P;?Mm=lg^;FWg6AK^;GdAUUc^;L<4jJc^;P>QMI[Y;THmb6G^;VkOb6[^"
    ";ZlR^:W^;eDaN>O^;hO`NBW^;mU`9Z3^<2FKf1k^<2d=R1_^<58@MI_p<>KdNA_^<@OBbAW^"
    "<A6i]nS^<C:62=c^<EB3j6G^<HSFImS^<P[_b>3^<Sf^bMO^<WSe=eg^<Y@lnbg^<a:OUV3^"
    "<e>jNAO^<f`I6U?^<l59j6G^<mK7UJ3p=4JjB>_^=8QTj>K^=:0Q^>c^=C?22Vg^=CCcZEg^"
    "=V^WVJ[^=YHnin3P=ZUA>6[^=]_dJ6[^=_<QJ:[^=aL4bVO^=afhaIo^=d;kUV?^=gCHiZC^"
    "=hF5eZW^=hc;aVS^=kjY5jC^>0m9:FO^>1`[>6O^>5QCMV?^>>Nbj5_^>Cf5R0[^>DE9>IS^"
    ">H:I=b3P>PXC1f3^>RD:ibS^>W7P6:S^>[^`B2[^>_p]FUC^>bR;jUG^>ceWaZC^>nD`::g^"
    ">oRBAm[^?7hDZZc^?80N:BW^?98lZIO^?9kbnB[^?:1dJAG^?<MW6:S^?@ALj1S^?A;VVES^"
    "?Ih7ANG[?QYXV2?^?TO79]G^?X8eZF[^?a=>bBc^?eCEEY_^?hj@2]?^?iEF5>;^@3VKBQC^"
    "@6?91Yk^@6EhFJ[^@=PjJJ[^@B<l:=S^@CW7Jbg^@D=DZ1[^@GGUb9g^@M2ZV=O^@RZn9j;^"
    "@X6`EMo^@[]m6FO^@]TPFEC^@`InfMC^A0GKB;;^A1U?NF[^A1Z12=c^A70_ZAK^A7hOBUK^"
    "A:@4JES^A;d4eaW^ABQ3:JO^AObB:F[^AV]C>jk^AX?in9O^AYHZNaO^A]NE=^C^A`UlBfo^"
    "AafTFa;^AfjD>YO^Aj`mimK^AlTUVBK^AmoDfNW^AoH>6YC^B2[FV=_^B;AIn=K^B<gZ:Z[^"
    "B>CkFBW^BDfPFV_^BE7?>5O^BLA96N?^BPhIBEW^BT_2n9K^BYFC:Y?^BZfH69[^B]mSF=C^"
    "BcDAj=c^BgEDf:O^BhB0JB[^Bn7Faf;^C29GQJc^C5`B>QG^C6U@UfC^C7W7MYk^C:h0B?7^"
    "C?3:MbG^CF2m6B[^CFO36>G^CFfO:>c^CGLpIeW^CM1X6N[^CM^f^=O^COYWNV[^CPM9R^c^"
    "CQ3FaYg^CS`B6>G^CXLgmb3PCYhU20c^C_^GBMC^C`jaaQk^Ca2G=lg^Cl=D5nS^Cm@12A7^"
    "Cm`NjFc^Co8pEb;^D0dTB:[^D3DdEmg^D8Oib6W^D:K>VZ[^D;1Kei_^DENL:2?^DO1VnBS^"
    "DQ7E26?^DRVejQC^DSjef5[^DTHWR1_^DVplN:[^DW>66MG^DY4YEjO^D[5KRbg^D`0>NB3^"
    "DcSEFbg^Dgp85ek^Dj7`ImW^DkXc9jG^E5K8bMK^EE3PV^c^EFQWaQ_^EFcDN=O^EHDc6Y?^"
    "EMQJJVk^EMYSn:G^ENDlRJc^EWR=2FO^EZ5nj>S^E_kEAF3PEdcL6NS^EhI?9B;^F0:D69C^"
    "F2OO5n3PF3[aJBW^F3cjj2K^F6fDV>S^F8C1VBW^F:mHmQg^F=6Fan[^F?@8VJ_^F@Ii26W^"
    "FC0NbRW^FDo;QmW^FHT8N5g^FPBSjEO^FZ8I:9O^Fa@iEj3PFeJORRS^FeiS>IW^Fi^c=mo^"
    "G3ohFAS^G;LW6Ac^G?JT:jo^GD6UjQO^GHXbMeK^GML7Z1S^GN4T^9O^GNNJj9k^GPEGeac^"
    "GT4DEfG^GUOMJ>[^GYGm69S^G[P=2B[^GpR>=b7^G]mG>:O^G^2166K^GcRnY^S^Ge081ek^"
    "Gff7>2S^GhaL2FG^GlAWJMO^H8ho]nK^H9]?^:[^H>IeQ]c^H@m3FEO^HBKfAEk^HBaXbBk^"
    "HFnN^NG^HI4<f>O^HMQ3^Fc^HM^HV6S^HOEY=Z3^HQR6Y^C^HZOV667^H_5DJB[^HcaF>=K^"
    "He;QJbg^HeWiJ6S^Hn5cAnW^Ho>Sb6[^I1=@QQ_^I1A`69_^I74f^=K^I7pMY^O^I=BG6BS^"
    "I>Ro69W^I?8jF=S^I@Ym5f7^IAnHjMK^IQkeB;;^IS9YNB[^IS>K69_^I[dNJEO^IaJaVBW^"
    "IbZ]f2G^Id5M:JS^Io78f:[^J1Fp:JW^J1KMb=o^J69_FQG^J6TeE^;^J8A]>fg^J?2_=bC^"
    "JJSNQUg^JL@VBno^JN8oVBS^JOS^fNO^JY`2JUO^Jpecn=O^J]7XIN?^Jf[Y>5[^JiUiJNW^"
    "JlF2BVc^K6>[Ffk^KDh[j=_^KG5]Mak^KG=fmf;^KIfJJFW^KK?g]RW^KO[`aj?^KR<:^Jc^"
    "KX9ZYb?^K[be5N7^KpLJB;C^K_9MAbO^KcOTeec^Kd`DRRg^KeFQamO^KnV26BW^L1SH9j3P"
    "L:1AmV?^L;Lo2<[^L;gA6>[^LBVa=lg^LECd=ZS^LH?<QfC^LI5pB9O^LJ8IBV_^LKI1BMG^"
    "LN^IVNc^LODhj>_^LR1ki^O^LRpFZQG^LSEYb2K^LZ4Cb:W^L[LQB>W^Lg2f>2;^LkXTRJS^"
    "Ll8UnQK^M46NFNc^M5G6F9c^M5O?f1[^M5cV65[^M5m1Um_^M8AFR>_^M8bP6EO^M>AOimK^"
    "MATXN>3^MKp:ImW^ML60ZA[^MM==:2;^MRCQ2VO^MVoRbMK^MXd8BJ_^M_X7mN7^M_a[:9g^"
    "MeR?mik^MfV4VYC^Mh?Tn=[^MhG^RAS^Mii=6UK^N5<UNYK^N7<mmUg^N96W6BW^N9<4JR_^"
    "N@2CjMK^NAO_AB?]NFLWZIk^NI@dB9K^NKUoAn3PNPT9Ze7^NSIX:i7^NT3i5Yo^NUHDj2G^"
    "NU_a1io^NYeMfFW^N[o[RJ;^Nc:9NN[^Ncm[V:S^NdThbRS^NfSUR1[^Ni@jREO^Nj0HnUG^"
    "O<9Bj=K^OBakNN[^OGMm>IK^OIDPNFW^O]1169g^O`nn:no^ObGgJY?^OeZojUK^Om:dQjG^"
    "OoXn^9S^P02dj=_^P5X^IfC^P=4W2F_^P=:XNAS^P>6X=^7^P?VK6:S^PBEB29?^PCh2Ve;^"
    "PDDJZIO^PFTR1fC^PLElNlo^PWPE]Yg^PZMI^2C^P[AY^JO^PbQMFIK^PdF2fBg^PhL9I]c^"
    "Po5M^FS^Q5=`Z9C^Q:4iZ5o^Q:LE]mO^Q@Y^JF[^QCQ^b6[^QD305EkYQEE`>=S^QJC`]R7^"
    "QJPIb5[^QJ_nJJW^QJn;N1[^QKoXYjS^QR^0Va;^QTTeeUk^QXY@^=_^Q]REEak^Q`?ZF]C^"
    "QcRbjEO^Qcd=RFg^QgQV2IG^QmJgjbc^Qn159Uc^R25P263^R3P?F;?^R4^3NF[^R4be6=_^"
    "R6nTYZ;^R=HhJJ3^REYg:FW^RJ=_J]?^RP[Rf:[^RRk6:JS^RRogb>3^RcYn^5O^RjINf2O^"
    "S839jZ_^S;DLJYO^S@Q3^^g^SAL_FBS^SD2YB5o^SH@3>5W^Sc9mJEG^SdFGiVW^Sf[J^^[^"
    "Shb@mf?^SiGF6BK^SkBZjRg^SkJdJFS^T1@:af?^T1`NEf3^T7NY2:O^T>0dBCC^TE3nem[^"
    "TGiMJAK^TM82N=G^TP:L6N[^TPgZ^=W^TS7b9R?^TTWU26_^TV^peA[WT]1I24c^T]K[::[^"
    "T_p<BAK^TaEp^6C^Tb<<M][^Td;;B4g^U0BcZN[^U0iBjB_^U45kQQ_^U;XKaQS^UAa0b=W^"
    "UGW51nS^UIZAF1k^ULGVJMG^UR:JnF_^UUZhFF[^UVRWmZ_^UYe`R:_^UZFj:EO^U_a8FB[^"
    "UbG2Aeg^UgbdMZ;^Um@TJ9S^V3gk2JK^V44f:5_^V8SlfEK^V8^X9J3pV:k5VBK^V<R_nMG^"
    "V@P]2>g^VDQ_mJK]VI_=JFW^VIl8R9[^VMO?JFk^VXaGmMc^VZV?M>;pVZ[16BK^Va5LUnS^"
    "VdpOMn3PVeppb>[^Vgl@6Jc^Vh11^Ig^Vjp6mF?^VmcT=^C^VoCG9^O^W1RXJaC^W6l^n2?^"
    "W7J>UNK^W7MDNBW^W8@fV6?^W;IgfFS^W<>cZQK^WF9BbRW^WH7oR1S^WJeDVIK^WTJJj2_^"
    "WYXhBFS^WdK76AK^Wf<h^IK^Wi2GBIK^WjEc5b?^X;N?f1O^X=_E6Fo^X>HP2Nc^XBSH:bg^"
    "XFAD]b?^XFaX=ic^XN_>QfG^XPHBUZ3^XQ=H^9_^X^Y12F_^X^_2N9S^X_E[VZW^Xa:e:6O^"
    "XehdZIK^Xi>DZ_3^XoJKJQK^Y0VeiYo^Y4XfYZS^Y:5FaQk^Y:6VVIC^Y<f3^BS^YARYUYc^"
    "YEjLfFg^YJ7B^R[^YN<7FAG^YSlp:9g^Yb>8NBW^YcJ@iMo^Yd4[ZAS^Yfj:>AW^Yhh0ee[^"
    "Yl4cb9c^YlRUR5W^Z:=Z^9[^Z<j]]jW^Z>HZVUG^Z?f61j;^ZA^2jZk^ZBD@9a_^ZE7<jEO^"
    "ZI606EG^ZVG?6=c^ZWcP>9O^Z]=NRV_^Z^mBJEo^Z_hefMW^ZaYER5S^Zg67Zfk^Zg>A:FG^"
    "ZhF_ZUC^ZmJOVYG^[1A9=eC^[4OP:FK^[4TAb9o^[5hIJY;^[85C=Ik^[FRHYnG^[Kmhf6S^"
    "[PK1b>W^[RaDNF7^[WHTZ9[^[[?>B=K^[]99NAS^[_fNNIO^[idMB5[^[l;]^bc^p<@MVIG^"
    "p=Lh1J;^p>3Q:MK^pJFZmf;^pLS8J>[^pV9bb^g^pVmDjVc^pWSR:5K^p_U>B;C^pc`HMj3P"
    "pf>RZIC^pfXHf1_^pk1gf=S^pl>BEV?^po8l>IK^]1^f6J_^]2]OInO^]3`<JIK^]6;o26S^"
    "]<D9bR[^]?05::[^]@kInRc^]E_UB4_^]Q2mZ6O^]RMpjBc^]Y71BQ?^]]=7f>W^]aUVfR[^"
    "]j3P^N_^^0ZMUm[^^3^dnF[^^44CEjC^^7?BFB_^^95eUmk^^;kD:EO^^=agEnG^^=kpV1[^"
    "^@iDYUk^^CkLB1[^^DkEIFG^^GHQ^2O^^KS[nNS^^NdnN=S^^Qe8EN;^^T1UbJ_^^ULE2RO^"
    "^Z8FfMK^^ZR=2:K^^ldZ:I7^_3p_YFG^_6ZOImG^_:;l^BW^_;8XBNS^_<2Omf?^_<?K6BS^"
    "_=boYn3P_=mdb1O^_>oAibW^_IPZ6R_^_IUK^E[^_WJ45mO^__8ORF3^_a0^M][^_g]pbR[^"
    "_lI^VEO^_mAFN1k^`4oajAS^`5j3FAO^`:P3^9W^`;=BFBO^`==H^]?^`Ej_N^_^`JVaBIO^"
    "`]2Yf5O^`_Gdib7^`eVC66K^`ge^]fC^`j39n:;^a0CXUbG^a2ab^5[^a8]:Qj?^a;?pRE_^"
    "a@=K2F[^aB9o^2_^aB_?:6O^aGM>ZI[^aI]F5V;^aJWiQ^K^aK`Z62S^aLkR^2C^aMNZ2>[^"
    "aM_FeVo^aR;?ibG^aT1?6Jc^aT>Siik^aWk@Yj;^aZY9]Z7^a^BD>Zg^a^JM^>C^ac1]j:G^"
    "ak[p^R[^anR1J2W^ao`QF=K^b2>AbFS^b5^_:6W^b<Pa5UW^b><XmjK^bCbRNFS^bE3:N1_^"
    "bHNT>=W^bMY=f9[^bXlV>9c^bY^VJAS^b[b4^9W^baoU:NW^bg5TeV;^c5>D61g^c7kY6=c^"
    "c9GjB1S^c<YjZIK^c>ahRV[^c@QpNAg^cC=_R5S^cGGkj:O^cHb[:BK^cQ3Yiag^cR`aZfk^"
    "cSdFf6O^cV3j>FO^cYY]=Ik^c`@=^i?^cmRBf6O^d2f=VBS^d49YN=[^d9pM2YK^d<^f^^k^"
    "d>]SN9[^dKHgB9[^dT55j6W^dVSH=J7^dXpF6F_^d_Wk:IO^daejQZO^dbC0MBGZdeYXU^O^"
    "dk@OjNc^e<fhYf3PeA9XB;G^eEDbMV7^eGblZAO^eKcoUZS^ePXTV:O^eRO7f1_^eSC@:R[^"
    "eU>TnFc^eY<R2a;^ep20Ve7^e]ELIR?^ealpUf?^ebOcn>[^egCoB4W^ei26miW^f1H9B^c^"
    "f2WGZ:K^f2XaFUG^f:[KBEO^f<CaJ9c^f>aQf6S^fDa[AeS^fR<Eb1[^fR>gUm_^fUiL=i_^"
    "fXcpFF_^fYodeY_^fZZ?V1k^f[[p^6K^f]O^:AK^ffAfN=_^fjkXQVC^fm6?je7^fn_`F5W^"
    "g0IHN9W^g6CPMn3^g70_2NS^g;p`fMK^g=]9B1O^g?p?b>_^gFRO>QG^gLc?eJG^gW4DnM;^"
    "gYicR]C^g]ce6FS^giZDf>S^gk546N_^gk9e^E_^h0PTB=O^h@piVIc^hIB6bN_^hK@cR5W^"
    "hMn8VAW^hQ_^V=K^hZ5`n^k^h[FHnYC^h`J1>5S^hgO9Nbc^hhh2^e?^hl;;BEO^i69:29O^"
    "i>W3j5S^i@l>ib7^iBX6f:[^iCTbFB_^iIJ8]fG^iJH=n]G^iN>gV=G^iPf1J>W^iRf7be7^"
    "iTF<^9W^iWUQNAW^ipd6VES^iaae2FO^ibcfAbC^idCY:2O^ifefmJK^igPAaeS^ihDJ2Vc^"
    "ii1XZIO^ikA`5^C^io@6jUK^j3_YibC^j<E9=e3^j@FCfBc^jDV7j:K^jGXQV2O^jI3@fJ_^"
    "jIln>bc^jJS;MQc^jQ@9b:K^jUWAAU[^jY>;nQC^j[51=Yg^jb;mJ:C^jeFlN>S^jf_e^]C^"
    "jj2n>=W^jjDHjBc^jjjV9iW^jlJ72:S^jo=Wf5[^joM<NFS^k3k3Bbk^k4Q@Qao^k72PV6S^"
    "k=FNb9_^kEJRJ1[^kL6ZVQG^kL>d6AO^kP<a:>_^kP]jbY;^kTU@:fg^kVb^5mc^kYKARBO^"
    "kYP36=o^k]3:2bg^k`FBVJ[^kb66NEc^kcWU6IO^khlEj:K^kj::65S^kjG5:>C^l;>7AAk^"
    "l>SEBjk^lAdWbi7^lG1?6o7^lGda:Ng^lGlj^N_^lO6pj2O^lSUcRBO^l[@g6YC^l^C@^J[^"
    "ld]p>V[^liZ8^E?^llmAB=_^lm;V2^c^loYhIEc^logQJFW^m19[F:S^m1bf>Nc^m9i]^Jg^"
    "m>Pmj:W^m@]AR8g^mA<E>MO^mSX=b9K^mUmHeb3Pm]>h9Q[^m^KBYZ7^mb^2BCK^md9;EjW^"
    "mhpGe]_^miGFZ=S^n4gZ:F[^n6bnnF[^n=VJVe?^nB8W9Mc]nFklF9S^nHhIBEg^nPVlJ>7^"
    "nRga^9O^nY4fBIO^n]2cA^G^nfACYfK^o36E1Qc^o3cAUmc^o7Mf=i_^o8mG6:K^o:H6J>c^"
    "o<>YV1g^o?48:EK^oAK@n6S^oD28YUo^oG0hJB[^oG4@Aic^oG>=>:S^oK1kEVC^oSoJbR[^"
    "oXU96N[^o]A:fAK^o_ASAiS^oei`1NG^of8ji^O^oh^HMfO^onQ=2A_^01H=N2O^03ah2AO^"
    "09TJUN3^0?K2n=_^0@[Zmn?^0FN=RN_^0MIbZ:O^0NZJZ>;^0S?daf3^0SCjV5_^0aBZB9O^"
    "0bSBB=O^0hA_2^o^0hEdeUo^0n8GJ>S^10R1n5[^157L:=C^1:n4M^?^1B1?227^1C6;b1O^"
    "1J9FEQo^1Oon^23^1VgN1fC^1W39BNc^1chfJ=K^1fBPnF_^21gV69W^28fZb>_^28j`U]c^"
    "2FiPB2K^2H:8En3^2Th?n6O^2Z^B9j3^2ZbGnQG^2gX52Fc^34F<^6W^3IOpImo^3V=d1mo^"
    "3WNL6:G^3j6[^5_^3kGC^=G^46lHajC^485KJ1c^4=kMQmS^4?4P6FS^4@I=mnK^4Kj=>5S^"
    "4RmGb9o^4S1MVQC^4`l7Mb?^4b<_Mb3^4mejJF_^4njg:F[^4o6RJFc^54do6U;^5:[WN1W^"
    "5A^b25_^5O]Q]f7^5Pn9^27^5cVIJEC^60L6N>[^61Q3=f?^62ea6AO^68XCV2C^6>Jf::W^"
    "6EIjj=C^6RC]b27^6ZKe::[^6`BMN23^6f5022W^6gEX2Zg^74;E:AG^7@iLb9g^7B5o1J?^"
    "7B:4f1W^7I=?J6W^7UkG26K^7i`8img^7k0`if7^80cCJ^_^80gIAIo^87^hR2?^87jSfB_^"
    "8COXieo^8KW`>=S^8RZjaN3^8XQS:5o^8Yb;9n?^8fPBan;^8g`jf:?^8lFDmao^8lJJb1_^"
    "9:I:NAS^9;YbN=K^9AH?>Nk^9ALE1Uk^9G>gV:S^9N=lB5G^9[7_=n3^9p<[n5O^9]IdJ:O^"
    "9c?fQYk^9i6Nj67^:09YNNc^:<oFV9O^:?I1:N_^:Jn6>5S^:Qm:nBc^:R1@aiW^:^_HN5c^"
    ":`00N:K^:a@XMn3^;3dbEek^;3hh:Y?^;?Mm=j7^;@^U>F_^;AcQmn?^;FM1mYk^;UpIZ1K^"
    ";bV<Umo^<0Tl>6G^<=FSRU?^<>S[j>C^<DMcj=G^<X;0BV_^<X?65f7^<YO^:6;^<e0]J1W^"
    "<l3gn1_^<l7mbMC^=:2WY^?^=;C?Yb7^=A9h29c^=FlJRJ_^=H=2VF_^=MkOBI;^=Sb7Z1[^"
    "=ZeB>5c^=hd1ij3^=j4Yj2;^>6baV>O^><piRIC^>IK1>9k^>IRVZ>W^>JWSIf7^>KlA>AO^"
    ">Q^cb67^>WQFF:S^>^PK69?^>kJ=n27^?3REB6S^?9HmYn7^?@L8>c3^?MAeF=G^?[<O9JC^"
    "?[@Tn5W^?bC_QfS^@BfY21_^@Bj^jES^@D7A5j7^@IicV^o^@Q13nFc^@cYCY]W^@d^@JEO^"
    "@enhJ=K^@kaJmN;^A1X3B5c^A2h[En;^A@gK2:?^AELe9f3^AEPjn1_^ASOZZE[^AT`BZ=K^"
    "AZN_JJc^AZRe=ak^A`EG^:K^B5C<:5S^B<FF]Uk^BI@9ZF_^BV5f^9O^BW>iFJW^BXOQFJ_^"
    "Bd4VJ=_^Bk3[:>_^Bk7`n5S^C23F65O^C96PZ:O^C:G8Z23^CLkBMio^CLoHBa3^CYe5JF_^"
    "C``ZQV7^Cgce6>W^Chhaf:K^Cnbif5G^D;pp]mo^DI[LJ2C^DVM3^IG^DWZ<6>C^D]TD6AC^"
    "DjBK^9_^E1APN2W^E2V>F:O^EE:H:67^EQlUVB;^ETI_eb7^E`2j^FS^EaCRbB_^Eg1oNIC^"
    "ElhWf1[^F3kbJ1c^FAjR5j3^FC;:62;^FUcI^EK^Fa<cQmk^FbY6f>[^Fc^3Uf?^Fcb9JAO^"
    "Fe2aJ=O^FiT[naK^Fja>:^o^FjeCmbG^G0WfR:W^G1pcB:K^G7Vk>=C^GDP^:27^GLXeN2W^"
    "GROMemo^GYRXJg3^GfHER=K^H4G5:5W^H;J?]ZG^HA<bB2[^H[m9>=W^H]=aAf7^Hikhj6S^"
    "Hj7T:Fg^I6e[f:?^I=d`V=S^I?5HV9O^IDgk9R3^IJ^SN=_^IKo;Qn;^IPQ61f3^IWP:aIc^"
    "IYmk::?^I^SEEb3^IlV:fAO^Imfbf=K^J3U?V:g^J3YEIm_^J@JlZ5G^JNIpF5O^JULfiYg^"
    "JbFYfF_^Jdp>Uf3^JiB>ij3^Jo<Fj9S^K0EINNG^K1V1RJ[^K7DN>9O^K=;6V9S^KD:;F:[^"
    "KD>A:=O^KJ0c]n_^KK9fB5c^KR=0f6K^KSMXf27^Kf1bYio^Kf5hNpo^L2kUVB_^L40REnC^"
    "L@jEB>W^LGiJ29C^LM`2F5o^LTc<imo^LbalV6C^LoSSjEO^M6ZdBAC^MCHkj9[^MJH0ZFW^"
    "MJL6Mn3^MKp^N:?^MRXCV1[^M]4F5bO^Mk:[>:[^MmP@1b7^N99JjF[^N:J2jB_^N@8OZAC^"
    "NEo81m[^NM2BUeg^NOGgF=S^N[12=io^NpAZB2;^Nb4<bV_^Nhoaj:K^Nj@In6;^Nned5ao^"
    "NniijAO^O;_W2>W^O<hYVES^O>9AVAO^OCg^FZ[^OCkd9ZG^OI^FZ:W^OP]KJ9G^OVT3aa[^"
    "O]W>F27^O^p;5iW^Oe_EYnO^OkUn223^P2MMF6S^P2Y8Vc3^P?NeZ=K^PAhPBFc^PJlEF67^"
    "PMMUF5S^PTLZ62W^PTP_iV?^PY2ZJ2K^P`1_9ik^Q53YJ9_^Q6DAIf7^QC>4FFc^QOl<2:O^"
    "QVk@^AO^QX;hb9K^Q]nKAUg^Qce3ZA[^Qe5[Yj7^R1ccEj7^R34KF>C^R7YeQf7^REp[2ES^"
    "RFmC2=K^RL[_^Bk^RL_eQm_^RRRH66O^RgP<R1O^RnSG5eg^RnWLj]C^S;M9nB[^SHBg69S^"
    "SIKiZBW^SJpQ^J[^SPJnJIK^SVAVb5S^S]@[R2_^S]DaFAO^SkCQ26G^SlT9223^T?8Beio^"
    "T?<HZa3^TL25bB_^TM72Qn?^TNK`F=[^TZ0eN>W^T`oj:9G^Tmi]5n3^U;hLaj?^UOaDNAC^"
    "UpOL69c^U]`465S^UcNPfBO^Udc>ZBS^V0D=imW^V1QFF>G^V7GHMeo^V=>0f2;^VFV`9b;^"
    "VLMHQZ3^VR?k6:[^VSDgf>[^VSPS6B_^V_5X>1[^Vem7N9k^VhNGR=O^Vn@j5fW^W43LV:S^"
    "W47RImg^W5H:N2?^W;:pnZ_^WGlDAak^WH0J6=O^WTf7::W^WUo9b9O^WW?abAO^Wpn>NRk^"
    "W]2DEV;^Wbdff:S^WickV5C^X6]^R27^X>eeefC^XDpN>23^XK_Xbc3^XXM`JBW^XXUEf=K^"
    "XZo0NBW^XfT5R5O^XmS:B2W^XmW@5V7^Y:EG]b7^YOJaUf7^YUAImj7^YpDTRJg^Yi2p:BS^"
    "Z01`jEK^Z1BHn5K^Z><;en3^ZL:kR:C^Z^c;:9g^Z`3c>=K^ZefE]m[^[3e5Ij;^[@Vp^9O^"
    "[GYgB5k^[G]m6YG^[TSZ:>W^[UXVinC^[aAaf:S^[aIGB5[^[bRIfNS^[cc1fF[^[iQNVU?^"
    "[n7Nij7^[oH6n5S^p6G;^:[^p6KARAS^p=B`aZC^pDJ19jG^pEZY>27^pRH`f>W^pX>c1io^"
    "pXBhfa3^pe10R=_^pe8UnB_^pf=R]f?^]37EV>W^]:6JF9C^]FdR1mg^]G0=B23^]O8DUjS^"
    "]Tnlmn?^]ZaON2W^]p27R:W^]bmpZFC^]hgdVAC^^5UlBAc^^6fTB1W^^<U12B[^^=i^fF[^"
    "^]G[UjK^^^LXEf3^^_]@Eb7^^eSh]Mg^^kFKBB[^^lW3B>_^_8<8F1[^_ATg^AS^_GGJ=Z?^"
    "_M9lb:O^_M>2V1k^_NNZV2?^_TA=:^c^_a6jB=W^_o1T5f3^_o5YnEO^`0FAn=S^`64^Zfo^"
    "`68dMQk^`;kG2:S^`Bfl9fC^`BjKb9G^`OXSJ5_^`Od>^27^`Pi;N1S^`WlF1V?^`]bnF27^"
    "`cUPj:K^`df8j^o^a1[f29O^a45PZB[^a?ZU^5O^aFYZN6_^aF]`AUo^aTpOn:O^agD_V5g^"
    "ahQAaeo^ahUGVAO^b5K4^Jc^b6P1Mj?^bI8A6EK^bWBp1n3^beAK^:G^bijkYj7^c6Y3Ef;^"
    "c7i[FAW^c9:CF=K^cEhK1m_^c``GJ9W^c`dMBYC^cmZ:F6S^cn_75^C^d;Xj2V[^d<iR2F[^"
    "dBWnbU;^dHNW:5_^dOM[f2c^dOQaZ=W^d]PQEnC^d^a9In7^dcC3j2K^djB8Yi[^e1EC=eg^"
    "e1II2U;^e>?66B[^e?D2in?^eL=eb>W^eS<jR=C^e`6]N27^eh>danS^elde5mg^en5M9n;^"
    "f58W^NW^f<4<bB?^fAnDbAC^fOm4N5S^fU[Q>BO^fW0?2F[^fiXNZAS^g7S8Qj3^g8c`Qb;^"
    "g>ZHiF3^gE]SNB_^gZ[GjEO^g`MjIV?^gfDRb1c^ggU:b2?^gmG]FR_^h4CBN2C^h5SjN6;^"
    "h:=JN9[^hH<:6IG^hILb:AO^hO;>fbo^hO?DYR3^hU1g>:O^hp0kn9?^hgNKV:7^hhj^f27^"
    "hofCn>;^i12f=V7^i6iNR63^i=lY6Vg^iJbF>=O^iM<0bJW^iXa5j9O^i_`:V:c^i_d@MUk^"
    "if_eR5_^imc06:K^jAWamf7^jA[gbIK^jNQTjFc^jOVQYnC^j[?pRFO^jb>aBAS^jcOIB5K^"
    "jiAkf2?^k0I<=mo^k>Gkj:C^kLF[V>K^kR@cR=G^kddmF1S^kf25b2;^kgB]anG^l9fgVA[^"
    "l9jmJQG^lGeWAjG^lMp?Z1o^lT_J>JS^lV02>F[^l[^Nn];^laU7B1W^lhXAf9c^ljmfZ=C^"
    "lnJdI^G^m6W1Qj?^m7gYR27^mJOi>QC^mWEVBB[^mXJS1j;^mY_@j=O^m_QcJ2O^meDEn>W^"
    "mlCJ^=C^n91RF=W^n9==Z23^nAEDn2[^nDZ]B1o^nG;mAj7^nN3LV6O^nN?7fN_^n[4dnAG^"
    "ngblZEO^ni3TZ1W^o06_>>[^oIVN:1_^oPYX]ig^oQj@]f;^oW`i5J3^o]SKV:W^o^d3ZB_^"
    "ojI8]m_^00002>3^0;fpjIG^0<CdFJW^0Khe9Yk^0UH<nFO^0ip42N[^19A4eYc^1=RQUiO^"
    "1B`LZJ_^1J6?M^?^1QP_MmO^1W4C^N_^1YnYAn;^1bLS6=O^208pB:K^22P7JUG^2=?_R5_^"
    "2?GRUIg^2DLSFJ[^2FpmJ:K^2K@oA]g^2PCFA][^2Y[g>>W^2Z[;>5g^2Z_A66C^2]Pkn6K^"
    "2_hG6]C^2b9a29O^2jWZfNk^2kVnj2C^31dc2JW^335T^5S^3;SNRF[^3=[Uii[^3Ji;Z2O^"
    "3M@VbQO^3ZHI:27^3_=2^N[^3k3eUmW^3kD<eb3^4<@0R2?^4BDCjAW^4XL5B5S^4eYZn6G^"
    "4h166MO^599n1ak^5EdDmmS^5J5a]mK^5M<AYf7^5^3oQeW^5^85F=g^5fQiF>W^5noc>EC^"
    "63<TUmS^6?kVfAO^6BaUNMS^6`TdB1S^6g>KEio^6lKW:QK^6n]165W^71_YRBS^77:jnJ_^"
    "78:?1f?^7?Xdb5S^7ADZIR7^7H6^VBW^7I62Yf3^7Mm3mmW^7RhT22W^7WLK]eo^7YcffEO^"
    "7jIOnEO^87gLj5g^8:lEBA_^8;ECZ1S^8G<6RQO^8Hc@V6C^92<k5f?^9ME>65O^9P09jFS^"
    "9VY1b1S^9_U:ab?^9alUfUK^:;S3B1[^:=HIVNW^:D0m6Fg^:LNfn9O^:LmJI^;^:ODeRUG^"
    ":gB3J9G^:j`YB^g^;3a[In3^;:EZ5R7^;;@A>1[^;<]5>QK^;C^;2B[^;D]O5^3^;DaTjJS^"
    ";L<4jEC^;TYn^B[^;UYBaf3^;X8hnR_^;pnn6VW^;]7hR=W^;j5DjQK^;nd;5nC^<0LO>:?^"
    "<DJ]263^<EQ8VR[^<RWF61_^<UFPZ:K^<WMTRQK^=2iHBN[^=7QGVMW^=c<Aie[^=enBZ=c^"
    ">?XIQjC^>H6CF=G^>H:I>1c^>MYgZNW^>PT=>Jg^>Y2721O^>YPZQ]g^?@DkQf7^?Fhj=Qg^"
    "?PAK:>W^?Q@_:1k^?X_DnAW^?a=>bB_^?b<Ref;^?i[8Z=S^?j0;JM[^@292NBW^@4A9eYk^"
    "@<o_An7^@Pmm627^@aYIQYg^@ai`ab?^@k8aF:K^A2eTN2;^AO1Y=Yk^AXQ0n:K^B<IhiYc^"
    "B@[EZ1O^BEi@Z:S^BH@[bQO^BTYSMe[^BT]YB9k^B]7MB6[^BeUG:AC^Bib8Q]c^C3APF2G^"
    "C5XkNYC^C6Q:b=S^CIeaN>O^CQ0@21c^Cpd[>>S^C]coAmg^C]h566G^C`Y`22G^Cc1;6a?^"
    "CeBU25W^Cm`NjNc^Cn_bj2C^D6>H^9S^D>pBRF[^DPIJbUK^D]Q=>27^DbEf^FW^DnM0eeo^"
    "E;J?EnK^E=aZNQK^E?HdR6?^ECLc9b3^EEM7nES^E[TiAmW^EhbO1nG^Ek9j:QK^Fa<cQi[^"
    "G28W>AC^G6EHZ1W^G:VQ22S^GEjINMO^GUI]MnW^GVLI6:S^Gc]XB1[^GjG?Eek^Gm8Pn=c^"
    "H1ee:5_^H:C^nF_^H;C31b;^H;G8fBO^HBaXb9S^HK?RZB[^HL>f]f3^HQ5gn9S^HXHc:MG^"
    "Hg236:K^I;0@n9g^I<2=J5g^I>N7ZAK^IGmOIZ7^IKl4V:G^IkfGF5[^J5E_5^7^JY>Vn=[^"
    "JYaeb1W^Jb]na^7^K>[gB9G^KCMdj:K^KG9a:Jg^KOWZn5O^KP6>M^7^KRMYRYG^KjJgJ9O^"
    "Kk4j]^?^KmiMBR_^Ko1DRBW^L=NN5Qo^L>I5>1[^LFfo6>W^LGfC5]k^LGjHj>K^LODhjEG^"
    "LWbb^B_^LXb6ab3^L[ApnNW^L`@pVAS^Lh^VJ>_^Ljf]aZ3^MANFN:K^MGSQ223^MHYlZRW^"
    "MX:NFA_^MX>mMZ7^MXOD^6O^MiK8En7^N62<BR[^NEW=9^7^NcJKnNW^Ng4:b9o^OK?7J9C^"
    "OS]1>>_^Op:k25O^OpYNQ]g^OnP=YnO^P2V1]nK^P>:kFJW^PJ1^=Uc^PSJ?:>W^PTIS>5k^"
    "PTMY2BO^P[h8n=O^PdF2fJc^PeEFej7^PlclZ9S^Q5AfNB[^Q7Imiag^QB22YQk^QT6a:27^"
    "Qdb=Q]_^Qe2TaV;^R5nHN6;^RB8DjAc^RR:M=a_^RlPCf6G^S?Rpi][^SCd9Z5O^SI24Z:O^"
    "SKIObQO^SWbGMmS^SWfMB1_^SYmhFFS^S`@AF:W^Sh^;:EC^SljlUa[^T6JDEnC^T8a_NQO^"
    "T9YnfAS^T;3M]j;^TZC<=a_^T_mO>:S^T`lcB5k^Ta0i6:O^TcbT1nG^Tf9o:QK^ThKI65W^"
    "TkN1RJW^U0iBjNg^U1hVn2C^U1lpb>O^U9G<^5S^UAe6VFW^UJC0J=_^UQ:c^27^USR>bQO^"
    "U`Z1>27^Ub1BR2?^Uf4bZ:S^V1Udimk^V>S3EnG^V@jNNQK^VBQXR6C^VkkC1nK^VnB^:UK^"
    "WI^QjJW^WL5ln5[^WSMi^1o^WYCR]nG^W[ZmfQK^Wc]QV=k^X5AK>=K^X5EQ223^X=_E6Fg^"
    "XF[bIjC^XI3=NQK^XJSW1Yg^Xa0KF5G^XdO1>Zc^XffLF5S^XmT9=f?^Y4421^?^Y4=XaN7^"
    "Y4nY:1[^Y6KM:MS^Y=LRn:W^Y>Kg1^3^YEjLf=K^YNHFZB_^YT>p2=S^YVf@NAW^YccpfQO^"
    "Yj:g:>K^Z>94n9g^ZAVkZMG^ZK6CMYo^ZO4hZ>O^Zno;F9W^[8NS9Uk^[pGK2ES^[efbaQk^"
    "[mRFAic^p9JgF>W^pAd[F5O^pJBU:Fg^pR`Nn5S^pS?2MMk^ppWgaj3^pjY7QeS^pmS[J=W^"
    "]12ABR[^]:3CMj3^]:7IB63^]@WB9Ac^]AQiB1_^]H3d25O^]Ioc6B[^]Jo79eo^]RMpjEK^"
    "]ZkVb>_^][jjaf7^]^JPnJS^]cIPV=W^]kgJJ>W^]moQeQo^^6^7>6;^^JpE223^^Kb`ZNW^"
    "^[GaMQo^^[X8]jG^^lSlJ27^_9;0FR[^_H`19R3^_R?HnFS^_fS?nV[^`68@eQg^`?WXVJ[^"
    "`En7J6O^`NGkJ5G^`NL1>1g^`SkOZR[^`VeeB>[^`_C_69K^`cPPQUg^`lohB6G^a:6kR5S^"
    "aAC_FR_^aCT9JBO^aM:R=]_^aVS3:6O^aWRG>5_^a_0m29g^agNffNg^ahN:in?^an[o2NW^"
    "aol`Z9S^b8JZRF[^b:Raii[^bFj]fR[^bG`GZ2C^bW?U:27^bp4>ZFS^bgk1Ue[^bh;Heb7^"
    "c97<N6?^cFWkaf;^cUCAAe[^dB[Pia[^dFlmZ1K^dL:h^6K^dRQGN:O^dZoAF5g^dcI5F2[^"
    "dkfo:EC^e03`Ue_^e9S8InK^e<bbfEO^eP7IN:O^e]L0AmW^e^0Lb6K^ec6CB2O^ed5WEig^"
    "ed9]:2C^efkH1fC^eiBc:QO^ekT=65W^eo6Vb6K^f426jNg^f4pTVEo^f51JmnC^f<P0b5S^"
    "fDmjVBW^fEm>Yf7^fJd?mmW^fTCW]b?^fV[2fMO^fcbe=n3^fhWNb:W^g4^Xj1g^g8<OV1W^"
    "gA[gIfG^gD3BRQO^gEZLV:C^geT_Ai[^go475jG^h1KR:QK^hO87mnC^hpLF]bG^h^cafUK^"
    "hgRQJ9o^i0o_B2G^i8J?B=O^i:?UVN?^i@h96F_^iIF2j=S^iIdVIbC^iL<1RUK^id9?F5K^"
    "igWe>Zc^iio@F9W^j7<f5ZC^j87M9mg^j9TA>UK^j@UG2B_^jAT[5R;^jAX`jBS^jI3@fAC^"
    "jQQ:ZB[^jRPN]f3^jU04jN[^jWGP29W^jYo4R=W^jdU5afC^jflPfUK^jmC[:>K^kAAhn5o^"
    "kD__^IK^kI2J::K^kR=pZ>O^ko`TBN[^l27oFAS^lSJPRMS^l_P?2EW^lhoVeYk^lkWgZ2G^"
    "m0oAQYS^m=RoJ2K^mDmOF9C^mI_Lj>G^mMKI:Jg^mUiC25S^mVGfMYk^mfe6Z=G^n4;5FR_^"
    "nC`69Qk^nDZ]Amo^nM8W6>[^nN7k9ik^nN<0n:S^nUVPnAK^n^4Jb>[^n_3^ef7^nfRDV9W^"
    "no0>NBW^o18EeYk^oMe9627^oNkTZJW^o^PUQYg^o^`lafC^o`h0VV;^ogomB>K^oop`J27^"
    "05eXmnK^08=46EK^0c=hYjK^0eUCbIK^0g5]EZK^1CHRV1W^1PV8EVG^1RmSNAK^1aQl1FO^"
    "2@Ec6EO^2K@oAag^2O3bJRW^2Y[g>:S^2^91nEG^2b9a29O^2gXI]V7^2jWZfNg^335T^9S^"
    "3;SNRJ_^3KQAV5W^3U0YIR?^3ZHI:27^3kD<eb3^48iQBEW^4<@0R6;^4BHi5R7^4oa8]R3^"
    "599n1ak^59@PRJ[^5M<AYj3^5MTGVR[^5S1jZ6O^5]9HIFK^5^85F=g^5noc>9O^6JQX5N3^"
    "6SlJ]Yo^6hDfjJS^6n]165W^77:jnF_^77igaR3^78>DfFC^7?Xdb9O^7ADZIZ7^7H6^VB[^"
    "7U]6VFW^7eB7IR7^7npj5^7^7naO>:S^87gLj5c^8C5FBJW^8Hc@V6C^8RZG5V3^8p9^jFc^"
    "90MUn>[^9IQnV2W^9]eeVN[^9_U:ab7^9ipXQQk^:9AYFIC^:D0m66[^:Lci^IG^:W4h9e[^"
    ":dBMj2O^;:EZ5Z?^;;@A>5W^;C^;2B[^;DM7eeg^;D]O5^7^;DaTjFC^;H;EajG^;L<4jEC^"
    ";QZ]V6S^;TYn^B[^;]7hR=W^<1eGQe[^<DJ]263^<EQ8VRW^<TlX^UC^<UFPZ6K^<_=W=i[^"
    "<hpnn2S^=2iHBRW^=LUfeiW^=enBZ1o^>9n6Qi_^>CMNEfS^>EdiJIC^>H:I>1[^>JS<:=o^"
    ">PT=>>c^>Z]lYVG^?0e]mjK^?3=96IK^?PAK::S^?T^Uj5O^?X_DnAS^?^=mYjO^?`UHbIK^"
    "?a=>bB[^?i[8Z=S^@292NFW^@KV=EfC^@MmXNMG^@Pmm623^@ai`a^;^@iDg2:K^A2eTN27^"
    "A8nM1bG^A;Eh6EK^AVa[fR[^AfFpYfK^Ah^7bIG^BD9kR^g^BL?_N:O^BS^lEVG^BT]YB9g^"
    "BV6GNIG^CCNW:EK^CLlAImc^CQ0@227^Cpd[>:S^C]h562?^CaAenEO^CeBU29W^Cm`NjNc^"
    "D0ffbES^D6>H^9O^D>pBRF[^DNZ5ZAS^D]Q=>27^Dg4pmmg^DnM0eek^E<2EF9W^E?HdR6?^"
    "EEQ]5Z3^EkK4=n7^F2ilaZ3^FP];VJW^F`B<MJ3^Fa<cQa_^G28W>9K^GMZL5Yk^GVLI6>O^"
    "H1ee:5_^H3BY:MO^H:C^nF_^H;2[aYc^H;G8f>G^H=J6ii[^HBaXb=O^HK?RZB[^HL86:J[^"
    "HQ5gn5_^HS]LN=S^HV6?N>3^I1jC>:S^I;0@n=c^I<2=J:C^IF>:BJW^IKl4V:G^I_BRjB_^"
    "J3VInN_^JLZbV6S^J`nYZN[^Jgc5UjO^JleLQR7^K6B3B:G^K:32B2S^K<JMFQ?^K>_m:5S^"
    "KG9a:Bc^KNFiBN[^KgKAj2O^Kib]2AK^L;_8nN[^L=NN5Z3^L>I5>1[^LFfo6>W^LGUkim_^"
    "LGfC5^3^LGjHj>C^LODhjEC^LTcQV2W^LWbb^B[^L`@pV=S^Lh^VJB_^M4n;Qi[^MANFN:K^"
    "MDS<JEK^MGSQ25o^MHYlZRW^MX:NF9c^MXOD^6K^MbFK>1[^MiK8En7^N1kL2ES^Ng4:b:K^"
    "O=6jV1c^OHm]NIC^OS]1>>c^O]f`YVK^OnP=Z:W^P2V1]mg^P3nR1bK^PSJ?:>S^PTMY2:G^"
    "PWgIjAK^P[h8n=K^PaFa]bK^Pc^<bEO^PdF2fFc^PlclZ9O^Q5AfNB[^QN_1EbC^QQ6LNEK^"
    "QT6a:27^Qe2TaV7^R2WiB5W^R5nHN67^R<7A1^C^R>Np:EK^RYjOfZ_^R`UE6J[^RiOP]b?^"
    "RkfkfMC^RlPCf6G^SC<K^9g^SGB_R^c^SVg`IR?^SWfMB5[^SY?;NMC^SfJefJK^Sh^;:5S^"
    "T4Zo>JW^T;3M]j7^TFWK:IK^T_mO>:O^Ta0i66K^ThKI65W^U0iBjNg^U1X?]^;^U1hVmf?^"
    "U1lpb:K^U3oZfAK^U9G<^9S^UAe6VFW^UJC0J=[^UOKNRFS^U]YpRIK^U`Z1>23^Ub1BR2?^"
    "V1Udimg^VBQXR6?^W62`aYo^WSMi^6;^WcK0MF7^X5AK>5S^X5EQ29g^XJSW1b;^XPc@9Yg^"
    "XffLF5[^XmT9=b7^Y4nY:5W^Y=LRn:W^Y>;Oa]k^YEjLfAG^YNHFZB_^YVf@NAW^YkS_M]g^"
    "Z>94n9c^ZAVkZ9_^ZO4hZ>O^ZXko9]c^ZbKFjF_^[6_=nJ[^[FD>e]g^[OcVV2W^[R;1^ES^"
    "[efbaUk^[mRFAeo^p3pNMac^p9JgF:S^p=;fB:S^p?SAJMC^pAha:9g^pJBU:>g^pRdTf1_^"
    "pS?2MV7^pTLDUZW^ppWgaj7^pjT5mnO^plkQ2EO^]:7IB1k^]@WB9F7^]AQiB1_^]CVc=ak^"
    "]H3d29_^]Ioc6>W^]RMpjIG^]WlEUnS^]ZC`^AO^]ZkVb>[^]cIPV=S^]kgJJBW^]moQeZ7^"
    "^EDUAnS^^Gp0JIK^^JpE223^^[GaMV3^^[X8]jG^^lSlJ27^_2pdmnO^_54@6EK^_H`19V7^"
    "_`54YnG^_bLO^EO^`@?^V5o^`En7J2O^`IZW>Ek^`MMDAVG^`NL1>5c^`VeeB:_^`mWnB1[^"
    "aVS3:2O^aXTCZ9c^a[0=jAG^a_0m2=g^adOU]^C^agNffJc^aol`Z=O^b8JZRJ[^bHHMV9[^"
    "bQgeI^C^bW?U:27^bh;He^3^bo[4>RW^c5`]B=_^c97<N6;^c?@51^;^c]3CjRW^cc8lnAO^"
    "clXD]Z7^dJKSVR[^dZ0TIN7^dZoAF9_^dkfo:9K^eGHd5]o^e^0Lb>K^ec6CAnO^ed9]:2?^"
    "ee<2jNS^ekT=65W^f426jNg^f4pTVAo^f4a3]Z7^f78NfEO^f<P0b9O^fDmjVB[^fRTBVV_^"
    "fb9CI^?^fcbe=n3^g4^Xj5c^gEZLV6C^gY0jf:_^glS;>2W^hO87n=c^hfSdMJ7^hgRQJ=o^"
    "i0QB=mS^i7Y>f:k^j4[jB6[^j7<f5bG^j87M:1c^j@UG2B[^jADCeac^jAT[5V?^jAX`jBO^"
    "jI3@fEC^jQQ:ZB[^jYo4R=W^jnpSQa_^kAAhn5o^kD__^ES^kR=pZ>O^keT:n:[^l6OnZBW^"
    "lRlJZ6[^lkWgYnG^m6eBQio^m<S[F6K^m@DZB2W^mBp5JQC^mMKI:Fg^mWU8UVK^md=R=ec^"
    "mmpin2S^n04E6EO^nC`69Qo^nDZ]Amk^nM8W6>[^nN<0n:K^nQUaf5S^nUVPnEG^n[59YjO^"
    "n]LTbIK^n^4Jb>[^nfRDV=S^no0>NB[^oHMIEnO^oJddJEG^oMe9623^o^`lafC^o`h0VB;^"
    "oop`J23^0200023P06P0063P0R000B3P1200023P13<00B3P13X00>3P16P00J3P17800F3P"
    "1R00023P1RT00>3P1VP00B3P22000:3P3200063P3R00063P@200063PA2000F3PB2000:3P"
    "L2000>3PP200123PP6400j3PP6P01n3PP8X00F3PP900023PP;000>3PPY000F3PQ0001V3P"
    "Q1<01J3PQ1X01>3PQ200163PQ3<01V3PQ4P01b3PQ5801F3PQ640123PQ7801^3PQ9000:3P"
    "Q;00063PQP001N3PQPT01J3PQR001F3PQRT01^3PQTP01>3PQVP01V3PR2001J3PR8X00J3P"
    "S0001:3PS1<01>3PS1X0163PS5801:3PS9000>3PSP001B3PSPT01N3PSTP01J3PT6400n3P"
    "T9000J3PU5801N3PU6400j3PU9000:3PU;000>3PUV401B3PW9000F3PWT401Z3PX8X00N3P"
    "X9000N3PXY000F3PY9000B3PZ8X00N3PZY000R3P[9000B3P[X<00V3P`2000j3P`9000N3P"
    "a200163Pa5801>3PcP001b3Pi9000B3PiZ<00N3Pj8X00R3PkP000B3Pl2000N3Pm1<00R3P"
    "m2000N3Po1<00J3PoP00063P0a@00R3P1<000V3P1C@0163P1O@01R3P1`@00V3P1o000Z3P"
    "26@00V3P2O@0163P2Y@00^3P39@00b3P3RP00V3P3]@01:3P3a000^3P48000B3P5WP00n3P"
    "5c`00^3P5hP00V3P6h`00F3P7iP00R3P7o@00V3P87P00J3P8@P00R3P8DP00^3P8[`00j3P"
    "8_@0123P8n000Z3P9N000N3P9U@00f3P9pP00^3P:1`00V3P:2P00n3P:2`00n3P;2@00N3P"
    "<E@00b3P<Q@00^3P>pP00:3P?P001>3P?n001B3P@D@00^3P@]P00R3PA8P00F3PBC000V3P"
    "BH`0163PBK`0123PBW@0163PB^`00Z3PBfP00n3PCcP01V3PCh001:3PDR@00R3PDZ`00>3P"
    "EE001N3PE`@00f3PFV001>3PHM@00R3PH[`00Z3PHi000^3PHoP00N3PIH`00Z3PIQP00R3P"
    "IWP00^3PJQP00j3PK?`0163PLPP00N3PLWP00j3PLY000N3PLgP0163PN9@00f3PN?001N3P"
    "NSP01F3PNb00163PNmP0163POG000V3POI@00b3POW`00F3POi001J3PQB00123PRQ@00>3P"
    "R`P00V3PS9@00B3PSIP01N3PT0`00j3PTN`00b3PU0P00N3PU3P01J3PU?000j3PUK`01F3P"
    "Ui@00B3PVQP00j3PV`000^3PWb@00B3PX0`00:3PX=@00^3PYRP00^3P[9P00R3P[G`00b3P"
    "[P`00Z3P[b`01F3Pp^000Z3Ppg`0163PplP00N3P^BP00J3P^DP00f3P^^@01V3P_NP00V3P"
    "_T@00^3P`J000^3Pa1@01>3Pb8001j3Pc>@00R3Pc``00^3Pd;`01B3PdV`0163Pdb000R3P"
    "e=000J3PeK`00Z3PeS000b3PeY000F3Pe_P00N3Pen000>3PfN000b3PfpP00j3Pg8000j3P"
    "ge`00V3Ph4@0163PhH000F3Phc000F3PiJ@00f3PiS@00V3PjQ@01R3PkD000b3Pk]@00J3P"
    "l?`00>3PlT`00n3PlY000Z3PlgP00R3Pn2000b3PoB000b3PoPP00j3P0J000V3P0PP01F3P"
    "0W000f3P0[000V3P1M`00n3P1Q000R3P1c@00j3P1g`00j3P29001>3P2FP0163P2MP00f3P"
    "2V@00R3P31`00f3P36P00b3P41P00f3P4E`00j3P4H@00f3P4J000f3P4pP00n3P4o000B3P"
    "53`00b3P56P00Z3P5D000j3P5EP00n3P5P000V3P5S00123P5XP00b3P5f`00j3P5l00123P"
    "66@00Z3P6>P00j3P6J`00n3P6Q000^3P6S000f3P6Y`00b3P6a@00j3P6l@00n3P7BP00f3P"
    "7JP00n3P87001B3P8k000j3P8l000b3P9;@00f3P9YP00b3P9Y`00j3P9oP00^3P:[P01F3P"
    ":m000f3P;AP00f3P;O001:3P<?@00f3P<V000b3P<i000Z3P==P0123P=CP00^3P=R`01>3P"
    "=S001R3P=`@00f3P=lP00V3P>8000j3P>]000n3P>mP00F3P?]`01:3P@cP0123P@mP00b3P"
    "A[000^3PB9000^3PB=@00b3PC8@0123PCI@01:3PCWP00J3PC_000n3PCfP00V3PCnP01>3P"
    "D5P00j3PD=000n3PDE001F3PDjP00R3PE2@01V3PEH000f3PEI`00f3PE_@00f3PFG000f3P"
    "FM@00Z3PFO@00n3PFe@00f3PGG`00^3PGW`01:3PG^@00j3PGj@01V3PHZ@00^3PIj@00n3P"
    "JQ000f3PJX@00j3PKD000j3PKX`00b3PL;`01:3PLA@00^3PLS000Z3PM7000f3PM@P00V3P"
    "Mj@00f3PN6P00j3PN=`01:3PNK@00^3PNZ`00j3PN[@0123PN_P00f3PNiP01B3PNm`00b3P"
    "O>@01R3POBP00^3POF`0163POX@00b3POc`01R3PPA@00^3PP]@00n3PQG`01:3PQJ@01:3P"
    "QK000^3PQO@00f3PQU`00V3PR3000j3PRc`00J3PRe`00f3PRl`00f3PS7`00V3PS8@00n3P"
    "SJP00V3PSL@00j3PSOP00R3PSU000b3PT0@00N3PT;@01F3PTO000n3PTVP00^3PT``00V3P"
    "TcP00^3PTe`00Z3PTm`00n3PU0@00N3PUL00123PUM@0123PUS000V3PVEP01B3PVE`00f3P"
    "VF`0123PVG`00V3PVI`00n3PV`P00^3PW5P0123PW7@00^3PW?@00^3PWJ`01R3PWR`00j3P"
    "XA@00Z3PXI@00f3PYL`0123PYi`00n3PZC@00j3PZP@00b3PZiP0123PZi`01:3PZn@00Z3P"
    "[Y000V3P[Z@00Z3P[k`00j3PpiP00b3P]@000j3P]I00163P]]P00n3P^CP00f3P^N000b3P"
    "^OP01B3P^X000j3P^pP00b3P^k000J3P_9`00b3P_DP01:3P_R@00R3P_d`00f3P`4P00n3P"
    "`9`01>3P`R00123Pa8P01J3Pa[`00^3PbT`00:3PcI@01:3PcI`00Z3PcoP00b3Pd2001:3P"
    "d7000^3PdDP01>3PdV@00V3PeH`0163Pe`000^3PejP01F3PelP00b3PfGP00j3PfH@00f3P"
    "fQP00b3PfV@00^3Pfn000j3Pg3P00j3PgL000V3Ph1@00:3Ph3P01F3PhY`0123PiRP00b3P"
    "iY000Z3PiYP00b3Pi`@0223PjC`00n3PjJ001:3PjV`00f3Pji000n3Pk1000N3Pl8@00f3P"
    "l:`00Z3PliP00b3PlkP0123Pm:@00Z3Pme`01>3Pmh`00^3Pn<`0163Pn?P00b3PnYP00^3P"
    "o4P00b3Po5@00j3Po<@0123PoC000^3Po`@00V3Pol@00n3P"
    "",
    "",
    {{
    {631, 1000, 155, 1117, 1615, 682, 856, 300, 585, 761,
     589, 375, -105, 436, 316, 574, -258, -239, -383, -730,
     -608, -219, -101, 322, -97, -359, -275, 180, -22, 53,
     44, 0},
    {934, 926, 217, 986, 1252, 881, 1099, 458, 377, 860,
     885, 518, 173, 434, 309, 0, -162, -21, -176, -514,
     -318, -157, -110, 130, 38, -376, -230, 63, 43, 121,
     -22, 0},
    }},
    {{
    {1797, 1520, 1218, 0, 0, 0, 0, 0},
    }},
    {{
    {655, 0},    {655, 0},    {655, 0},    {62, 20},
    {128, 20},    {132, 20},    {15, 20},    {47, 20},
    {450, 2},    {90, 20},    {43, 20},    {69, 20},
    {79, 20},    {372, 20},    {133, 20},    {4, 20},
    {1253, 20},    {431, 20},    {72, 20},    {36, 20},
    {96, 20},    {85, 20},    {108, 20},    {104, 20},
    {1395, 20},    {214, 20},    {400, 20},    {186, 20},
    {85, 20},    {183, 20},    {6, 20},    {209, 20},
    {215, 19},    {655, 0},    {655, 0},    {274, 4},
    {193, 15},    {189, 18},    {168, 18},    {51, 20},
    {2274, 20},    {350, 4},    {236, 15},    {102, 20},
    {115, 20},    {85, 20},    {63, 20},    {43, 20},
    {1598, 20},    {187, 20},    {82, 20},    {425, 20},
    {38, 20},    {27, 20},    {43, 20},    {29, 20},
    {4778, 20},    {1726, 20},    {208, 20},    {247, 20},
    {13, 20},    {25, 20},    {28, 20},    {10, 20},
    {362, 5},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {519, 1},    {196, 9},
    {3280, 17},    {655, 0},    {450, 2},    {300, 6},
    {315, 7},    {286, 8},    {265, 9},    {335, 5},
    {124, 20},    {335, 5},    {122, 20},    {68, 20},
    {93, 20},    {80, 20},    {100, 20},    {68, 20},
    {3663, 20},    {3468, 20},    {406, 20},    {20, 20},
    {32, 20},    {49, 20},    {1642, 20},    {21, 20},
    {4449, 10},    {655, 0},    {655, 0},    {655, 0},
    {403, 2},    {519, 1},    {313, 4},    {146, 17},
    {450, 2},    {655, 0},    {519, 1},    {371, 3},
    {382, 4},    {450, 2},    {318, 4},    {276, 5},
    {1500, 20},    {289, 8},    {248, 8},    {102, 20},
    {103, 20},    {51, 20},    {32, 20},    {18, 20},
    {3107, 20},    {1967, 20},    {21, 20},    {873, 20},
    {818, 20},    {25, 20},    {529, 20},    {8, 20},
    {655, 0},    {655, 0},    {655, 0},    {205, 20},
    {67, 20},    {85, 20},    {7, 20},    {13, 20},
    {280, 16},    {734, 20},    {285, 20},    {246, 20},
    {40, 20},    {175, 20},    {110, 20},    {48, 20},
    {1361, 20},    {767, 20},    {278, 20},    {369, 20},
    {71, 20},    {133, 20},    {65, 20},    {168, 20},
    {2684, 20},    {395, 20},    {98, 20},    {142, 20},
    {88, 20},    {79, 20},    {854, 20},    {47, 20},
    {132, 20},    {655, 0},    {655, 0},    {207, 11},
    {94, 20},    {926, 20},    {1479, 20},    {63, 20},
    {1544, 20},    {304, 5},    {847, 20},    {45, 20},
    {637, 20},    {390, 20},    {1355, 20},    {296, 20},
    {1895, 20},    {45, 20},    {755, 20},    {75, 20},
    {13, 20},    {297, 20},    {411, 20},    {276, 20},
    {7097, 20},    {2140, 20},    {319, 20},    {74, 20},
    {272, 20},    {14, 20},    {843, 20},    {4, 20},
    {203, 20},    {655, 0},    {655, 0},    {371, 3},
    {450, 2},    {296, 6},    {371, 3},    {178, 20},
    {162, 20},    {519, 1},    {350, 4},    {129, 20},
    {149, 20},    {217, 12},    {289, 8},    {57, 20},
    {2174, 20},    {145, 19},    {876, 20},    {312, 20},
    {32, 20},    {37, 20},    {116, 20},    {13, 20},
    {9180, 20},    {4354, 20},    {880, 20},    {406, 20},
    {9, 20},    {1236, 20},    {106, 20},    {6, 20},
    {7078, 20},    {655, 0},    {655, 0},    {655, 0},
    {382, 4},    {265, 7},    {304, 5},    {102, 20},
    {3595, 13},    {519, 1},    {450, 2},    {185, 13},
    {308, 8},    {450, 2},    {519, 1},    {10, 20},
    {5469, 20},    {175, 20},    {128, 20},    {31, 20},
    {85, 20},    {100, 20},    {244, 7},    {5, 20},
    {9576, 20},    {5554, 20},    {2466, 20},    {2136, 20},
    {586, 20},    {1153, 20},    {121, 20},    {2, 20},
    {655, 0},    {655, 0},    {655, 0},    {373, 20},
    {180, 20},    {67, 20},    {82, 20},    {28, 20},
    {223, 20},    {732, 20},    {647, 20},    {765, 20},
    {179, 20},    {197, 20},    {252, 20},    {84, 20},
    {2393, 20},    {1690, 20},    {1232, 20},    {744, 20},
    {291, 20},    {345, 20},    {256, 20},    {267, 20},
    {4853, 20},    {1540, 20},    {773, 20},    {535, 20},
    {252, 20},    {253, 20},    {243, 20},    {265, 20},
    {2257, 20},    {655, 0},    {655, 0},    {1684, 20},
    {1240, 20},    {404, 20},    {75, 20},    {324, 20},
    {2457, 20},    {2890, 20},    {1762, 20},    {1123, 20},
    {138, 20},    {287, 20},    {563, 20},    {589, 20},
    {5821, 20},    {2617, 20},    {1601, 20},    {1223, 20},
    {181, 20},    {506, 20},    {11, 20},    {310, 20},
    {10395, 20},    {3070, 20},    {1150, 20},    {951, 20},
    {505, 20},    {928, 20},    {973, 20},    {11, 20},
    {5126, 20},    {655, 0},    {655, 0},    {335, 5},
    {1987, 20},    {245, 15},    {247, 13},    {1937, 20},
    {5496, 20},    {6214, 5},    {2620, 19},    {2392, 20},
    {1606, 20},    {160, 20},    {165, 17},    {87, 20},
    {10067, 20},    {1368, 20},    {1764, 20},    {1074, 20},
    {430, 20},    {233, 20},    {73, 20},    {324, 20},
    {13725, 20},    {3771, 20},    {1595, 20},    {1682, 20},
    {795, 20},    {18, 20},    {714, 20},    {10, 20},
    {16076, 20},    {655, 0},    {655, 0},    {655, 0},
    {4340, 8},    {248, 9},    {272, 6},    {2251, 18},
    {14358, 20},    {382, 4},    {156, 20},    {631, 20},
    {731, 20},    {2276, 20},    {245, 7},    {118, 20},
    {19832, 20},    {1464, 20},    {1688, 20},    {2077, 20},
    {804, 20},    {803, 20},    {1137, 20},    {19, 20},
    {19329, 20},    {6395, 20},    {3376, 20},    {4061, 20},
    {3667, 20},    {6280, 20},    {16826, 20},    {501, 20},
    {655, 0},    {655, 0},    {655, 0},    {492, 20},
    {350, 20},    {175, 20},    {126, 20},    {154, 20},
    {307, 20},    {1062, 20},    {667, 20},    {699, 20},
    {336, 20},    {204, 20},    {150, 20},    {98, 20},
    {2211, 20},    {1822, 20},    {1000, 20},    {719, 20},
    {472, 20},    {492, 20},    {180, 20},    {127, 20},
    {3793, 20},    {1846, 20},    {1456, 20},    {1048, 20},
    {780, 20},    {816, 20},    {257, 20},    {114, 20},
    {4047, 20},    {655, 0},    {655, 0},    {1219, 20},
    {1953, 20},    {1494, 20},    {1058, 20},    {498, 20},
    {6177, 20},    {1888, 20},    {1209, 20},    {1101, 20},
    {1050, 20},    {1019, 20},    {617, 20},    {155, 20},
    {10311, 20},    {3165, 20},    {2136, 20},    {1597, 20},
    {1230, 20},    {1494, 20},    {473, 20},    {171, 20},
    {11460, 20},    {3542, 20},    {2286, 20},    {2034, 20},
    {1413, 20},    {1359, 20},    {555, 20},    {197, 20},
    {8147, 20},    {655, 0},    {655, 0},    {135, 20},
    {4054, 20},    {3067, 20},    {2604, 20},    {1437, 20},
    {16291, 20},    {4691, 20},    {3229, 20},    {1920, 20},
    {1591, 20},    {1894, 20},    {1697, 20},    {204, 20},
    {12785, 20},    {3785, 20},    {2578, 20},    {1632, 20},
    {1550, 20},    {1612, 20},    {380, 20},    {133, 20},
    {12948, 20},    {5678, 20},    {2729, 20},    {2867, 20},
    {2365, 20},    {1885, 20},    {1105, 20},    {413, 20},
    {21235, 20},    {655, 0},    {655, 0},    {8634, 10},
    {3789, 20},    {4817, 20},    {1122, 20},    {1817, 20},
    {22826, 20},    {6047, 15},    {2128, 20},    {2123, 20},
    {3478, 20},    {5781, 20},    {1799, 20},    {704, 20},
    {20722, 20},    {7318, 20},    {7407, 20},    {4351, 20},
    {3611, 20},    {4377, 20},    {1428, 20},    {546, 20},
    {19683, 20},    {7109, 20},    {7013, 20},    {8950, 20},
    {4729, 20},    {2955, 20},    {2256, 20},    {650, 20},
    {655, 0},    {655, 0},    {655, 0},    {650, 20},
    {887, 20},    {663, 20},    {471, 20},    {406, 20},
    {240, 20},    {1346, 20},    {1105, 20},    {743, 20},
    {474, 20},    {1038, 20},    {374, 20},    {326, 20},
    {3570, 20},    {1952, 20},    {2031, 20},    {830, 20},
    {1288, 20},    {1978, 20},    {1312, 20},    {614, 20},
    {4638, 20},    {2250, 20},    {2824, 20},    {1173, 20},
    {2805, 20},    {3966, 20},    {857, 20},    {390, 20},
    {6362, 20},    {655, 0},    {655, 0},    {43, 20},
    {437, 20},    {2547, 20},    {1152, 20},    {2065, 20},
    {1993, 20},    {2532, 19},    {342, 20},    {12, 20},
    {145, 20},    {732, 20},    {148, 20},    {500, 20},
    {3761, 20},    {1335, 20},    {1591, 20},    {1001, 20},
    {425, 20},    {1150, 20},    {499, 20},    {456, 20},
    {7081, 20},    {4284, 20},    {2219, 20},    {2518, 20},
    {4831, 20},    {2974, 20},    {47, 20},    {2273, 20},
    {6288, 20},    {655, 0},    {655, 0},    {10690, 2},
    {382, 4},    {291, 7},    {308, 5},    {3149, 12},
    {7941, 20},    {10454, 3},    {212, 7},    {75, 20},
    {109, 20},    {109, 20},    {114, 20},    {97, 20},
    {5753, 20},    {115, 20},    {68, 20},    {2442, 20},
    {2383, 20},    {4752, 20},    {93, 20},    {950, 20},
    {6240, 20},    {5129, 20},    {3801, 20},    {1337, 20},
    {4763, 20},    {3111, 20},    {1969, 20},    {3887, 20},
    {11706, 20},    {655, 0},    {655, 0},    {655, 0},
    {7478, 5},    {5871, 7},    {3968, 9},    {335, 5},
    {4771, 20},    {655, 0},    {7510, 5},    {238, 7},
    {193, 13},    {265, 7},    {184, 10},    {267, 8},
    {6479, 20},    {3022, 19},    {2613, 20},    {1875, 20},
    {107, 20},    {126, 20},    {2964, 16},    {2890, 19},
    {7464, 20},    {7737, 20},    {6307, 20},    {5660, 20},
    {3060, 20},    {3152, 20},    {2577, 20},    {9821, 20},
    {655, 0},    {655, 0},    {655, 0},    {789, 20},
    {826, 20},    {683, 20},    {350, 20},    {298, 20},
    {2868, 20},    {1565, 20},    {2134, 20},    {1653, 20},
    {2054, 20},    {2454, 20},    {1504, 20},    {702, 20},
    {11480, 20},    {5370, 20},    {5774, 20},    {3608, 20},
    {3114, 20},    {7495, 20},    {2271, 20},    {1106, 20},
    {15810, 20},    {8258, 20},    {9130, 20},    {6037, 20},
    {6712, 20},    {14244, 20},    {5390, 20},    {1963, 20},
    {7828, 20},    {655, 0},    {655, 0},    {1530, 20},
    {6412, 20},    {2905, 20},    {4294, 20},    {1723, 20},
    {7266, 20},    {3773, 15},    {4590, 20},    {2240, 20},
    {1692, 20},    {5823, 20},    {2778, 20},    {2007, 20},
    {16607, 20},    {7670, 20},    {7362, 20},    {5650, 20},
    {4218, 20},    {8826, 20},    {5326, 20},    {1376, 20},
    {21000, 20},    {13522, 20},    {14922, 20},    {13166, 20},
    {15565, 20},    {19301, 20},    {6714, 20},    {1067, 20},
    {13826, 20},    {655, 0},    {655, 0},    {519, 1},
    {350, 4},    {27745, 11},    {9418, 7},    {5512, 20},
    {14080, 20},    {519, 1},    {7510, 5},    {3341, 11},
    {168, 16},    {213, 11},    {2611, 20},    {1200, 20},
    {17781, 20},    {9991, 20},    {7632, 20},    {5037, 20},
    {4514, 20},    {4818, 20},    {5860, 20},    {577, 20},
    {20540, 20},    {11931, 20},    {16603, 20},    {11399, 20},
    {8813, 20},    {8311, 20},    {2058, 20},    {1011, 20},
    {22582, 20},    {655, 0},    {655, 0},    {519, 1},
    {403, 2},    {15579, 4},    {6597, 7},    {10690, 2},
    {17868, 20},    {655, 0},    {267, 6},    {7776, 14},
    {141, 20},    {8601, 3},    {159, 10},    {1853, 20},
    {20496, 20},    {6612, 20},    {12109, 20},    {7855, 20},
    {5534, 20},    {15401, 13},    {7609, 20},    {5653, 20},
    {20075, 20},    {17030, 20},    {15991, 20},    {12567, 20},
    {10155, 20},    {16609, 20},    {7215, 20},    {1153, 20},
    {655, 0},    {655, 0},    {655, 0},    {723, 20},
    {443, 20},    {349, 20},    {240, 20},    {185, 20},
    {199, 20},    {1719, 20},    {1850, 20},    {995, 20},
    {738, 20},    {1139, 20},    {938, 20},    {770, 20},
    {4372, 20},    {5040, 20},    {2339, 20},    {2003, 20},
    {1402, 20},    {2147, 20},    {879, 20},    {1060, 20},
    {11024, 20},    {9494, 20},    {4250, 20},    {3055, 20},
    {1239, 20},    {1361, 20},    {1264, 20},    {468, 20},
    {1662, 20},    {655, 0},    {655, 0},    {1267, 20},
    {58, 20},    {2400, 20},    {2310, 20},    {1828, 20},
    {7354, 20},    {158, 12},    {2721, 20},    {1635, 20},
    {1221, 20},    {1877, 20},    {432, 20},    {1333, 20},
    {12237, 20},    {8677, 20},    {3707, 20},    {5176, 20},
    {2403, 20},    {1701, 20},    {1820, 20},    {2251, 20},
    {23911, 20},    {14856, 20},    {9034, 20},    {9483, 20},
    {5730, 20},    {2354, 20},    {4968, 20},    {3706, 20},
    {9173, 20},    {655, 0},    {655, 0},    {519, 1},
    {222, 9},    {655, 0},    {12876, 6},    {6187, 5},
    {19178, 20},    {519, 1},    {267, 6},    {4710, 11},
    {2837, 19},    {169, 13},    {107, 20},    {77, 20},
    {15449, 20},    {10235, 20},    {5645, 20},    {10040, 20},
    {3244, 20},    {4807, 20},    {105, 20},    {1010, 20},
    {27077, 20},    {18782, 20},    {9579, 20},    {14619, 20},
    {12969, 20},    {4262, 20},    {3992, 9},    {4272, 12},
    {28011, 20},    {655, 0},    {655, 0},    {25610, 2},
    {8596, 5},    {14172, 1},    {244, 8},    {25610, 2},
    {39675, 20},    {655, 0},    {8721, 4},    {15871, 12},
    {6929, 16},    {371, 3},    {4361, 12},    {238, 7},
    {27707, 20},    {22320, 20},    {11112, 20},    {13169, 20},
    {8586, 20},    {2814, 20},    {10256, 20},    {3712, 20},
    {25949, 20},    {23862, 20},    {18651, 20},    {21560, 20},
    {10780, 20},    {3797, 12},    {28880, 20},    {11320, 20},
    {655, 0},    {655, 0},    {655, 0},    {943, 20},
    {552, 20},    {430, 20},    {468, 20},    {257, 20},
    {238, 20},    {1018, 20},    {2460, 20},    {1849, 20},
    {1122, 20},    {269, 20},    {395, 20},    {329, 20},
    {3815, 20},    {3227, 20},    {3030, 20},    {1891, 20},
    {1238, 20},    {386, 20},    {334, 20},    {423, 20},
    {5938, 20},    {5668, 20},    {2096, 20},    {2408, 20},
    {939, 20},    {724, 20},    {658, 20},    {259, 20},
    {2346, 20},    {655, 0},    {655, 0},    {1263, 20},
    {1953, 20},    {207, 20},    {571, 20},    {945, 20},
    {2831, 20},    {2290, 20},    {2142, 20},    {2305, 20},
    {1534, 20},    {378, 20},    {379, 20},    {31, 20},
    {6512, 20},    {2703, 20},    {2476, 20},    {3050, 20},
    {1707, 20},    {419, 20},    {459, 20},    {708, 20},
    {14126, 20},    {7397, 20},    {5239, 20},    {5122, 20},
    {1794, 20},    {924, 20},    {1740, 20},    {1223, 20},
    {4487, 20},    {655, 0},    {655, 0},    {655, 0},
    {4475, 12},    {313, 4},    {137, 15},    {2179, 20},
    {8215, 20},    {5416, 6},    {134, 15},    {5823, 20},
    {1888, 20},    {38, 20},    {30, 20},    {502, 20},
    {7824, 20},    {2374, 20},    {3635, 20},    {3856, 20},
    {1753, 20},    {1280, 20},    {11, 20},    {870, 20},
    {18454, 20},    {7768, 20},    {4588, 20},    {7402, 20},
    {2844, 20},    {1132, 20},    {2303, 20},    {1241, 20},
    {21762, 20},    {655, 0},    {655, 0},    {9416, 4},
    {164, 10},    {655, 0},    {16176, 20},    {13346, 20},
    {30101, 20},    {655, 0},    {3028, 19},    {20575, 20},
    {10172, 20},    {105, 20},    {5096, 20},    {5617, 20},
    {21594, 20},    {4277, 20},    {7732, 20},    {10445, 20},
    {7542, 20},    {1078, 20},    {2942, 20},    {4772, 20},
    {25933, 20},    {13519, 20},    {10248, 20},    {11937, 20},
    {6018, 20},    {1815, 20},    {5093, 20},    {2721, 20},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {164, 20},    {655, 0},
    {3258, 20},    {655, 0},    {10900, 20},    {655, 0},
    {580, 20},    {655, 0},    {3941, 20},    {655, 0},
    {10552, 20},    {655, 0},    {1248, 20},    {655, 0},
    {8026, 20},    {655, 0},    {12156, 20},    {655, 0},
    {3203, 20},    {655, 0},    {19692, 20},    {655, 0},
    {21467, 20},    {655, 0},    {14, 20},    {50, 20},
    {73, 20},    {96, 20},    {1478, 20},    {2259, 20},
    {114, 20},    {175, 14},    {273, 7},    {304, 5},
    {13306, 17},    {17084, 20},    {214, 20},    {626, 20},
    {2640, 20},    {12995, 20},    {17916, 20},    {31875, 20},
    {710, 20},    {1021, 20},    {3886, 20},    {14858, 20},
    {22749, 20},    {37709, 20},    {6554, 20},    {10170, 20},
    {22811, 20},    {40503, 20},    {45646, 20},    {51336, 20},
    {26, 20},    {109, 20},    {498, 20},    {1592, 20},
    {1514, 20},    {27222, 20},    {606, 20},    {499, 20},
    {2045, 20},    {3092, 19},    {12009, 20},    {38453, 20},
    {122, 20},    {374, 20},    {1698, 20},    {3829, 20},
    {4941, 20},    {34167, 20},    {674, 20},    {981, 20},
    {3828, 20},    {12829, 20},    {14048, 20},    {42516, 20},
    {4818, 20},    {6598, 20},    {12242, 20},    {28565, 20},
    {24528, 20},    {45984, 20},    {94, 20},    {980, 20},
    {555, 20},    {2053, 20},    {2077, 20},    {10506, 20},
    {3252, 20},    {1540, 20},    {7348, 20},    {7393, 20},
    {10392, 20},    {30889, 20},    {357, 20},    {460, 20},
    {2480, 20},    {5181, 20},    {8189, 20},    {26286, 20},
    {172, 20},    {245, 20},    {2056, 20},    {7201, 20},
    {8902, 20},    {24317, 20},    {1376, 20},    {2646, 20},
    {5837, 20},    {15444, 20},    {18302, 20},    {37190, 20},
    {277, 20},    {571, 20},    {1677, 20},    {2257, 20},
    {6468, 20},    {8873, 20},    {4167, 20},    {4979, 20},
    {12503, 20},    {16306, 20},    {12141, 20},    {30633, 20},
    {1528, 20},    {1414, 20},    {4094, 20},    {5898, 20},
    {11669, 20},    {24543, 20},    {314, 20},    {492, 20},
    {1571, 20},    {3039, 20},    {9030, 20},    {20287, 20},
    {1156, 20},    {1045, 20},    {5416, 20},    {6130, 20},
    {22426, 20},    {20189, 20},    {759, 20},    {645, 20},
    {6462, 20},    {5820, 20},    {21686, 20},    {22061, 20},
    {6935, 20},    {7416, 20},    {9863, 20},    {16033, 20},
    {14554, 20},    {34360, 20},    {985, 20},    {2621, 20},
    {2836, 20},    {9475, 20},    {5032, 20},    {29521, 20},
    {226, 20},    {959, 20},    {1309, 20},    {4203, 20},
    {5386, 20},    {26658, 20},    {792, 20},    {1053, 20},
    {2484, 20},    {2467, 20},    {10243, 20},    {17927, 20},
    {141, 20},    {341, 20},    {307, 20},    {1698, 20},
    {11118, 20},    {23451, 20},    {128, 20},    {602, 20},
    {181, 16},    {3382, 20},    {4763, 7},    {24722, 20},
    {149, 20},    {467, 20},    {53, 20},    {2424, 20},
    {159, 20},    {24674, 20},    {240, 20},    {1244, 20},
    {461, 20},    {1988, 20},    {6871, 20},    {18055, 20},
    {655, 20},    {420, 20},    {6030, 20},    {1895, 20},
    {350, 4},    {21309, 15},    {4, 20},    {183, 20},
    {52, 20},    {1052, 20},    {69, 20},    {2757, 20},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {16534, 20},    {9910, 20},    {14220, 20},
    {7046, 20},    {2997, 20},    {4372, 20},    {4665, 20},
    {655, 0},    {896, 20},    {7439, 20},    {12003, 20},
    {11263, 20},    {5600, 20},    {7171, 20},    {4514, 20},
    {655, 0},    {36399, 20},    {34792, 20},    {28310, 20},
    {35382, 20},    {31288, 20},    {37773, 20},    {33732, 20},
    {33794, 20},    {34053, 20},    {34952, 20},    {33513, 20},
    {36308, 20},    {34608, 20},    {32082, 20},    {35298, 20},
    {31532, 20},    {33382, 20},    {31061, 20},    {38292, 20},
    {32773, 20},    {35587, 20},    {34387, 20},    {38224, 20},
    {30866, 20},    {38936, 20},    {34586, 20},    {29295, 20},
    {35028, 20},    {36301, 20},    {34696, 20},    {36020, 20},
    {29544, 20},    {30572, 20},    {32771, 20},    {31249, 20},
    {31649, 20},    {31560, 20},    {33438, 20},    {28459, 20},
    {32173, 20},    {32954, 20},    {27548, 20},    {30759, 20},
    {30354, 20},    {34138, 20},    {34233, 20},    {31653, 20},
    {32555, 20},    {33122, 20},    {32876, 20},    {33011, 20},
    {34551, 20},    {26112, 20},    {32388, 20},    {32026, 20},
    {35965, 20},    {28746, 20},    {30627, 20},    {31813, 20},
    {29505, 20},    {32777, 20},    {29815, 20},    {29510, 20},
    {655, 0},    {18961, 20},    {28381, 20},    {28605, 20},
    {36144, 20},    {22752, 20},    {30090, 20},    {28412, 20},
    {32126, 20},    {27713, 20},    {25757, 20},    {26908, 20},
    {30075, 20},    {31681, 20},    {32210, 20},    {35674, 20},
    {31428, 20},    {37002, 20},    {21977, 20},    {33742, 20},
    {27267, 20},    {31291, 20},    {29749, 20},    {35707, 20},
    {30329, 20},    {36357, 20},    {28475, 20},    {34565, 20},
    {33803, 20},    {30112, 20},    {30813, 20},    {33840, 20},
    {30138, 20},    {33440, 20},    {32123, 20},    {33581, 20},
    {24768, 20},    {24406, 20},    {31496, 20},    {30156, 20},
    {27430, 20},    {29663, 20},    {29593, 20},    {36557, 20},
    {28167, 20},    {29409, 20},    {29743, 20},    {34756, 20},
    {29694, 20},    {31043, 20},    {29463, 20},    {34371, 20},
    {29321, 20},    {33402, 20},    {31828, 20},    {33501, 20},
    {30940, 20},    {32625, 20},    {33992, 20},    {31544, 20},
    {32462, 20},    {30426, 20},    {30873, 20},    {36577, 20},
    {655, 0},    {32719, 20},    {31890, 20},    {34865, 20},
    {31216, 20},    {34536, 20},    {32749, 20},    {36548, 20},
    {27579, 20},    {29352, 20},    {31549, 20},    {31044, 20},
    {30706, 20},    {31354, 20},    {31534, 20},    {34110, 20},
    {37395, 20},    {32789, 20},    {30320, 20},    {33165, 20},
    {28055, 20},    {34510, 20},    {32907, 20},    {30957, 20},
    {30697, 20},    {33805, 20},    {29483, 20},    {32207, 20},
    {32244, 20},    {34360, 20},    {28102, 20},    {36860, 20},
    {31610, 20},    {25308, 20},    {32152, 20},    {32925, 20},
    {27699, 20},    {29213, 20},    {33438, 20},    {35160, 20},
    {29274, 20},    {31021, 20},    {29394, 20},    {32385, 20},
    {30615, 20},    {33653, 20},    {26645, 20},    {34972, 20},
    {30409, 20},    {29360, 20},    {31029, 20},    {32924, 20},
    {30037, 20},    {32121, 20},    {29716, 20},    {35288, 20},
    {30693, 20},    {32007, 20},    {31440, 20},    {31559, 20},
    {29011, 20},    {33186, 20},    {36132, 20},    {33124, 20},
    {655, 0},    {32591, 20},    {32196, 20},    {30309, 20},
    {32591, 20},    {31819, 20},    {35324, 20},    {31145, 20},
    {36851, 20},    {37965, 20},    {32230, 20},    {36442, 20},
    {32380, 20},    {35298, 20},    {29037, 20},    {31703, 20},
    {28307, 20},    {32229, 20},    {33821, 20},    {30861, 20},
    {32469, 20},    {33655, 20},    {31807, 20},    {28721, 20},
    {34498, 20},    {32640, 20},    {32426, 20},    {35485, 20},
    {38317, 20},    {37671, 20},    {34919, 20},    {36485, 20},
    {29868, 20},    {30063, 20},    {30520, 20},    {26003, 20},
    {27742, 20},    {29287, 20},    {38232, 20},    {33754, 20},
    {28716, 20},    {30134, 20},    {31747, 20},    {28923, 20},
    {30811, 20},    {28811, 20},    {33524, 20},    {31197, 20},
    {29186, 20},    {36115, 20},    {28390, 20},    {33262, 20},
    {28939, 20},    {32478, 20},    {30721, 20},    {39999, 20},
    {28925, 20},    {30284, 20},    {29233, 20},    {28125, 20},
    {28291, 20},    {34852, 20},    {31783, 20},    {26449, 20},
    {655, 0},    {23305, 20},    {27066, 20},    {24216, 20},
    {34318, 20},    {27675, 20},    {25403, 20},    {29407, 20},
    {30538, 20},    {26021, 20},    {26322, 20},    {32428, 20},
    {26551, 20},    {31134, 20},    {35037, 20},    {26564, 20},
    {30345, 20},    {40737, 20},    {22472, 20},    {31546, 20},
    {28267, 20},    {35664, 20},    {31923, 20},    {41378, 20},
    {32603, 20},    {31220, 20},    {39905, 20},    {40921, 20},
    {28652, 20},    {41018, 20},    {21975, 20},    {28172, 20},
    {35793, 20},    {22322, 20},    {26549, 20},    {31809, 20},
    {29030, 20},    {42044, 20},    {17925, 20},    {31730, 20},
    {21052, 20},    {27009, 20},    {29143, 20},    {43342, 20},
    {22189, 20},    {29828, 20},    {26043, 20},    {31536, 20},
    {24818, 20},    {22363, 20},    {22375, 20},    {36536, 20},
    {27473, 20},    {27077, 20},    {31759, 20},    {17649, 20},
    {32173, 20},    {31143, 20},    {32002, 20},    {14291, 20},
    {43120, 20},    {20519, 20},    {26425, 20},    {27015, 20},
    {655, 0},    {33637, 20},    {29847, 20},    {33741, 20},
    {31764, 20},    {29174, 20},    {32702, 20},    {33670, 20},
    {27820, 20},    {28674, 20},    {28163, 20},    {32527, 20},
    {28489, 20},    {32555, 20},    {31571, 20},    {29143, 20},
    {35134, 20},    {36077, 20},    {26894, 20},    {34881, 20},
    {28861, 20},    {31160, 20},    {28564, 20},    {34767, 20},
    {28109, 20},    {32403, 20},    {29866, 20},    {34255, 20},
    {27269, 20},    {34646, 20},    {30687, 20},    {35365, 20},
    {31408, 20},    {28183, 20},    {30351, 20},    {31678, 20},
    {30276, 20},    {26568, 20},    {28619, 20},    {32895, 20},
    {28994, 20},    {28389, 20},    {31381, 20},    {29588, 20},
    {30100, 20},    {28482, 20},    {28373, 20},    {31710, 20},
    {31380, 20},    {28236, 20},    {31030, 20},    {32690, 20},
    {28112, 20},    {31760, 20},    {29848, 20},    {30998, 20},
    {29935, 20},    {29627, 20},    {30537, 20},    {34220, 20},
    {29583, 20},    {28088, 20},    {31860, 20},    {32650, 20},
    }}};

}  // namespace unstep::codec::warm
