// Made by tests/bench/train_warm_start.sh; do not edit.
// clang-format off
#include "codec/warm_start.h"

namespace unstep::codec::warm {

const std::array<std::uint16_t, kContexts> kCounts = {{
    833, 634, 322, 218, 207, 691, 431, 234, 333, 556, 416, 1441, 113, 180, 291,
}};

const std::string_view kRecords =
    "00001Z?^06aDZAO^072mE]o^0?P6V5[^0?^4bNW^0B[oiZ;^0DClFJ_^0K`fBEK^0MhXnRW^"
    "0Q_i9m_^0jpX6fo^0oJPBR[^16ndnQ7^1<:;nNW^1DHGfZc^1RAJan_^1U0A^EK^1_lPR=S^"
    "1aYkBMG^1bRcZFo^1i]X]ao^1oVFR^c^2MJI5bC^2X:12Rk^2YPDb5C^2[IpfMC^2_J[B9_^"
    "2a^]ZFW^2dBJ^V[^2jglJMG^32lT5]c^35mU2>_^36CVnQK^36G=J6W^39=Zj:[^39M<EZK^"
    "3;58bRO^3<KYRNS^3BOV]iW^3B[p]j?^3DKoZQ?^3P6^NVc^3QV<abO^3WB`bEO^3pR3b9S^"
    "3_H1ifW^3`AR=n?^3hf3^Fg^3l4<bIS^3l69QbC^46A5Ij[^4CH>]f;^4D4C:Z[^4Ee[mfO^"
    "4KABnN[^4OJRJYC^4ZCc2:C^4b<VbNS^4c9kV=G^4f3dmZC^4j<^JE_^4mP7e^W^5@pgQRK]"
    "5L>;mbK^5M<AY]o^5TmFZ5S^5XlCUb7^5_RMQ^;^5lmfFZc^5nh52B[^5o3i1Yo^6Jn7ZEO^"
    "6pgTBA?^6^O7eVS^6kcL]n3^7@DiBQO^7Jgn:JW^7LINB=g^7LeP^IO^7QGVM^?^7VJ=F=C^"
    "7WaX>Z[^7`g]1mc^7aRVjQK^7fA`2EO^7gY7JBO^7hTTNN_^80_4iaO^83><Mmc^870EUi[^"
    "87l4^QC^88;iM^?^8<XY1nS^8?Alj63^8AeAF=K^8J;D=N7Z8McNJ>_^8[8P1VO^8gfW]^?^"
    "8k4H5Yg^96R:BIG^9<;:UYc^9A[OjVk^9Fe>FMK^9K1T^Vc^9Z5>Z1S^9Z:92NS^9_AEJ>[^"
    "9`[UJAO^9ckA>N[^9hINba;^9kg^j2K^:09TnRS^:23=2a7^::7d^9C^:>O9N5k^:CooA^[^"
    ":DOQJfk^:L?RfMO^:TnDb=K^:VLKMnS^:YbLUak^:]2lMec^;1GX5nS^;5WSiMO^;703I]?^"
    ";@P3V2O^;MIfR:[^;V:U>IS^;XlYfNc^;aJX:5k^;jNOjU?^;j^;:];^<3T=Q^W^<5MH=YW^"
    "<61pB9O^<7HBfa;^<9f_R1[^<;j72Jc^<<?SN=7^<B44bF7^<D1[JZ_^<DQ:f>W^<DXhnNO^"
    "<SBneU[^<TC6bES^<p3;NMG^<c61NZg^<fUSi^7^<j[QanS^<mW`ZAG^=0G6:Y?^=7IYM]o^"
    "=7QGUZ7^=BJ8n>W^=Ee9J>W^=MEPV:[^=UOG>a;^=V1HnAS^=XAKfFc^=YHniag^=[U[jMO^"
    "=]bF>Ic^=`KlAnS^=`P?FAO^=boYAJ3^=gXl1^O^=hTOmfW^=mMMEac^=mX7ZR_^>7U6nY?^"
    ">=EU5iS^>GdMNBS^>Hfn^JS^>Lm^Ib7^>P1^^QS^>SbNZ>_^>XW3ZZc^>^[0f9K^>`C<ZAK^"
    ">mndJB[^?4pWFMK^?6]VFFc^?;Cf5jW^?Bj=FIK^?G39BJc^?GcQB>S^?H=Y2Vg^?I0R2QG^"
    "?K?^9Yo^?ONcF=W^?XP]:J_^?b5IbVW^?dKA6AO^@9TG22O^@>H0jR_^@BGAnUK^@L=aNBS^"
    "@LKnQa_^@Q;YbAK^@_`<FN_^@c36J^g^@gbie]o^@lLeY]o^@n4b6:o^@o<mRBc^A0fAU]o^"
    "A;k5>F[^A>5>f:W^A@Xkj>W^AGF_bB[^AXDHRMC^A[WamZS^Ae`K2^c^AhEiU^C^AmU<V2W^"
    "B0I=nJS^B384fMC^BLQ=AaO^BQM7F9O^BSFj:^_^BS_SUNK^BVW>iek^Bb?JfIS^BeMXnBW^"
    "C3m2Jbc^C;?g=jK^C=YHmbC^CBb>Z9C^CGQ4A^;^CJUY>:W^CTTQ5jS^CXA3nNO^C[oC5F3W"
    "CeBU2F_^CkWUf1S^Cl68G8k^CmPfZBS^D3K=:JW^D5Z]BQK^D:^h1RG^DE:iU^;^DVp>V2C^"
    "DcJF=jC^E38K2NK^E7G1]iW^E<fUQn7^EDYjIVG^EFcDN=C^ELfPBB_^EXme5NS]EZcWB^_^"
    "E^VN]U_^EkK4=Qk^EoZ9J5S^F2U_]nG^F6hfJ=W^F?^niVG^FFPCR=O^FL<mea_^FOT]ZQG^"
    "FPE5]^?^FRhJ:Rg^FZPe:Zc^F]7nmU_^Fa2ARIW^Fa@iEZ3^FbRX2QC^FcZSmUk^FeJOS@c^"
    "Fi0ln5O^FjVn:9O^Flc65]_^G0PA6Vc^G2Ii:EO^G6T>AYg^G:NPfEG^GFT8n:_^GFiUF=O^"
    "GQ]p:N_^GWhG:B_^GXj[jk7^Gdc:J5O^GhA`bAO^H5SO9QK^H6H>=^S^H9756MG^H9LWUfK^"
    "H@aU6YK^HFVcBU?^HORBB5g^HPGkMe[^HPTT2:_^HSCJjEO^HSU3UZS^HVpmb=C^HYCEnNg^"
    "H`32VAC^H`eljFk^H`f2VB[^Hg01f9S^Hk8[bIC^HlXd>Jc^HnAoN5W^I:=KYiW^I>[Y>Zk^"
    "IBJ`j9_^IG>^Fbg^II<;AU[^ISYZmMg^IeXRJI?^Ij`oB>k^Il``VZO^Imo=Ie[^In2bFI;^"
    "IncQ1jW^J0Qc5ZK^J2M`nBO^J;]CnB[^J<NVbAO^JF?^mac^JPA_2EK^JS7=UYk^JVR4AfG^"
    "JXX7n>_^J`H<VF_^JeF?Ub?^Jmd9MZ3^K0=d1Z?^K4p7BNo^K>ZiN:O^KGJ2ZMG^KRQ]jFS^"
    "KVXMQV3^KYdHIf_^Kde@MnS^KfRP2:K^KlXd^R[^Kn8C5ZS^L1SH9^C^L9O[M^C^L;YoNQC^"
    "L@1T>Zc^LRc;]fW^LU6>aiK^LUP5nYC^L]eVa^C^L_jDmNS^L`VINNW^La4gRFS^LklXZUK^"
    "M2pC:5c^M6eJ2QG^M>^]2BW^M@4b1Q[^MA=dVZg^MBUkAVK^MG?>QZK^MQREj5S^MX@LfEW^"
    "MY`Qb5O^MZVm2Zk^M`Ql:Zc^Mc2IV9K^MgPW:Rc^Mg`Y9^7^N5NIi^3^N6ZX:Jg^N91eM]k^"
    "N961nNO^N:H3ZU7^N>Kjn>[^N?1166O^NDnPMaO^NFpC6B[^NYeMfNg^N_LNm^C^N_e`6a?^"
    "NaL@F9c^Ne;H2:W^NfnajZ[^Ng6Jf9g^Nn9QjES^O1iO]f3^O6O2Y^C^O:GIQ^;^OQccNAO^"
    "OpYIY^C^OpfoRMK^OadjF1K^OiGQEZ3^Oi`bNEW^OnZWN>[^P2lCZ9K^P5hLEZS^P>4]:MO^"
    "P>>=Z5g^P?VK6;7^P@0=e]_^PBcfFEG^PD;=Z:O^PE32IYo^PE8GVQG^PG==V=K^PJlEF6W^"
    "PL0DAESWPSRKemO^PYLM9Mc^P`YLi]S^PcbGJIC^PjETZ:[^Q3BSYYc^Q3nX:V_^Q@SRZNC^"
    "QAefiYo^QD>hJ5W^QGVNER;^QO3InIS^QS4@REO^QX]@iY[^Q][7]eO^Q^=V>^_^QcGDZIO^"
    "QgSZnV[^Qhia25S^Qjco]Yc^R9o^N2c^R:AHZQG^R==[^AS^RBF0EaW^RD@?1]g^RDkU6]?^"
    "RF]f6BW^RNUCFU?^RO<oaic^RVYk2=K^R[3BB1S^R[nf>Zc^Rd25^IG^RfH]nN_^S1PK6M?^"
    "S5[L2YC^S>J=n9K^SFjYY^?^SG<djN[^SK8EZFK^SOc_fRW^SaI:ZV_^Siklb2O^Sj7lVRW^"
    "T:6>Y]o^T;=gRF[^T?VNJEO^T@]B>^o^TFDREiW^TG@ANY?^TGko=j?^TJYhA^;^TNcNNm7^"
    "TQ3Z]U_^TR[W6J[^TSjI6Y;^TT@RYYg^Ta3A6>?^Tc8QN9[^TfgY9fO^TkD=2^_^U02;R1k^"
    "U0e=6A[^U8UA^UO^UFmOJY;^UG:7nJW^UI8?UnS^UNDgnUO^UOhij>O^USk_]ZC^UW3Yj=W^"
    "U_g;iU[^U`I^]]_^Ul5OUUg^UoPFB1W^V21MR]G^V2@b>2S^V4cR6J_^V5fC>BW^V7][V]?^"
    "V90DfE7^V9CK=]o^V=2EVEO^VE6V=bO^VEQ^iUk^VHiN^9S^VIl8RAO^VJ:=jJ[^VX?jBA_^"
    "VYg[EeS^Vp0Z=^S^V`UK66K^VejLnRW^Vkc_fUG^VlNI:]?^VlSdn=C^Vm7L^ZS^W0DTj2S^"
    "W0RamUc^W7<;fMk^W83:Z>S^W:1ZJ5k^W<eBjIO^WCh@=fC^WF_b62W^WIpaQao^WJPj^>W^"
    "WMjMRF_^WPXK:>3^WQ>]VEG^WSMi]V3^WcU?RB[^WdEWV2S^Wjln:Xk^Wo>`2IO^X52cJ>O^"
    "X<P<Qic^X>WP2R[^XCPibEW^XF6fiV?^XKS`BU?^XRhJ2Zg^XXpkB6S^XZL^^MK^XbQFIY[^"
    "Xm]`6AG^Y8N;J=G^YE7e2MK^YHnkiZ;^YXM;N6S^Y[d?QE_WYiAg6=k^Z21>]^?^Z51SnV[^"
    "Z:=Z]ic^Z>9Z2N[^ZB^6Ij3^ZJ7Bf2S^ZLkD>BW^ZXED=^3^ZYaP^YG^ZYe7::_^ZZmY:R_^"
    "Z_adN9K^Zmo=Z=O^[0AYeRO^[2o9>MO^[71DB6[^[:`ZREK^[C_Kmn3^[GhRfFS^[KOS6b_^"
    "[[=;R5K^[];[Aj?^[iCUYnS^[jcZVJS^[lTc:EO^[n2iefS^p16WEfG^p>0JB6O^pFWeBEK^"
    "pO[pEac^pP49jA7^pPn1V:_^pR<cRMO^pW@nEJKVpXJNAic^pd:aAVO^pi7kYV3^]0hhj2C^"
    "]4X?:V_^]8K@F5S^]<<0B6S^]>C[6F_^]?<Z^:W^]AQiBB[^]LY_>IK^]Si7meS^]pG:Y^;^"
    "]``VU^3^]d_ZbVc^]nL1FEK^^4EDBNW^^5e7:E3^^9k=^Fg^^:ckAfG^^Am1U^C^^L<?Z9O^"
    "^OAFMmo^^RkmbQO^^SJlZA[^^V;PJ>S^^_AA>5_^^h7HQZO^^i2DfNc^^l6cnMG^_4eP=b?^"
    "_72kNVW^_86]ZMO^_9Z5=Ug^_?4^BUG^_ES3B5K^_G94N=K^_L2N>N_^_M2GFR[^_R9_fEC^"
    "_T<nYe[^_W0W:EO^_[InJQ?^_`6RanS^_eC;6IS^_mY=mMg^_mafQi7^`4JMN>W^`4g@eYS^"
    "`5Lb>fk^`=jdfRW^`>VIa^[^`KDQN6G^`RjDMVO^`Un]ijS^`c8iRUG^`hG6jB_^`l4HR9g^"
    "`m6ZB:S^`oI9AbC^a1cKNBS^a5eL>6c^a8PZA^7^a:0M>2[^a<U8f9?^a=S8EmW^aB_?:Nc^"
    "a[=_N^g^a^lg:9k^acO=V=[^agmK:g3^b0;a=N?Zb8_nYVK^b?Rh]aW^b?nk:QK^bCkORF_^"
    "bIBfjZ[^bOQ6>=?^bPNpEnK^bUV@5>3PbcmmF>S^blL;]ac^boYCiVK^c5:>=nG^c<jBf>[^"
    "c?O2Z=S^cAhEi^;^cEhK1]k^cI@:f1W^cJF?]Z7^cL_jEMk^cMlIZe3^cXU^B6_^cXZOjQC^"
    "cXkAmY[^c[<ob:W^c_H0bVk^ch6b^FS^cnBej5S^d0J7iaW^d0W>F:7^d0iN5Mk^d;cOfR[^"
    "d<G@BIO^dH`dIbC^dJ3MY^3^dN5NI^;^dNA9Z6W^dSdofUC^dX<5^UG^dZoAE^?^d^^WVNW^"
    "deTcQbK^diC36>[^diFlU^?^e0cJBBc^e1XE1eO^e<fhYak^e=Vmb:c^e>F[V2[^e?3UZIG^"
    "eFMS1^C^eK4c=f;^eMA;ZUG^eMoenJ[^eO>IJ4c^eOMJ5VG^eSGPFMK^e[30^Y7^e[i1NAg^"
    "ep4RIRS^epVhEYS^e]_jjZ_^eaVPEU?^f3Sa:Jg^f6BX61W^f793FRc^f96P=R7^f<4mJZO^"
    "f=42JV[^f?TOf9K^f@Ahf6G^fB8jV5S^fD2]JV[^fTT2Uf?^fUSk]]k^fZ[D>>_^fpVi5jO^"
    "f^a_f>c^fc>IJ>g^fkOgR>O^flNKbUC^fo0DjIK^g;nU=Mk^g<GfJe;^gCPh:^_^gGi:bIK^"
    "gIQD>FS^gV:mf>S^g`891Yo^gaejZ^G^go[[>J_^hC>66R_^hEiWUV;^hU:BBNS^hUI^9iS^"
    "hWc?mZ7^hXkD]fO^hZ`CjF?^h^6Qen[^haZMfIG^hc_CfEG^hd6eVRS^hgNKUf7^hjdYR>W^"
    "i0NoR1c^i5nSIIopi=;S9IkXi?5[YbO^i@DMZEO^iD9CJ6W^iI>Dbbk^iKccEb?^iOdYmN7^"
    "iPP^JR[^iVUnVM?^iZAoJZc^ioo71UO^j189VR_^j6dcjZ_^j<ha5]_^j=[bYmg^jSXc2JS^"
    "jVcNjE?^jWJl6fk^jZ1?BIG^ja7B]f;^ja<4BN_^jc?lFJW^jc]AfEO^jfTm:fo^kDE4=ac^"
    "kINI:BW^kOK0NNc^kPn`FNO^kR=RFQK^kVi6fVO^kZdV6A?^kfbXb9?^ki`bjRW^l0kWm^S^"
    "l::8FFK^l<l]mf?^lFh?mmo^lJZhVNW^lVAGe^O^lVXDi]c^lW_mfBG^l]?HNJg^l`DOB5c^"
    "ldN5N1o^lj61MZ7^m0DJ2:O^m77RV5O^m<F]^AW^m<K^eNC^m>8ME]C^m>APn^c^m?ZW^5W^"
    "mCI_Mf[^mIFb5Yk^mPSaiY_^mYNIb6W^mZN6]Qc^mc<hY]g^mcOUZ]C^mgCDBEO^mjfn>IG^"
    "mo?<FQK^n3U`:5W^n6FCj^o^n<kdm]W^nHWUeUc^nPJ_>Fg^neKTn5O^nfFPZM;^njGO2AS^"
    "nl8>6>?^o1G0:1S^o8R`M^S^o;`gj1[^o=7QF:G^oBLS>JS^oI0OJQK^oIYS2^_^oK_ZNAO^"
    "opTnfEO^ocAhF6S^od?NbUC^oe;iaeW^olXJ29G^00001Z?^02KbRQO^02[N6=[^03be:RS^"
    "0<nQFQO^0?P6V9k^0RIeEUo^0YAAn=S^0gID2QS^0heY>UG^0i5gbIS^0jUX]Y;^1<p::];^"
    "1BAhR1S^1BTQ6RG^1N1[b>W^1i]X]Yk^1oVFRbg^23?LVYK^2@?gjUK^2AOajjo^2GbVbV[^"
    "2ICB9Qo^2Nfe21O^2Ue=BVW^2UlIVAO^2YPDamC^2dBJ^VW^35mU2:_^37fGaM_^3;58bNg^"
    "3@UIRbk^3@^_aiO^3B[p]j?^3DG5>]C^3F8_F=O^3NHDVV_^3Z0a6EK^3^Rj2NO^3_UnJAO^"
    "3akR:R[^3g^LfIO^3jFIbMK^4CH>]jS^4F?N6Zc^4ZCc2:K^4p0Sba;^4kipUQc^52K_jIS^"
    "5;?5nJW^5Kgo=Y[^5XlCU^O^5]JhabS^5^KK]fO^5b9P6EO^5iTDbEC^5mGFMZC^60lEJNW^"
    "64BQfIS^65Ep25O^67DJ:VW^6L]@BFO^6Q8NjV[^6QH]NV[^6QnG]fO^6REefEC^6cCO2J[^"
    "6gHi>J[^6iCQ:>c^6kcL^27^7LINBEg^7S3Z5Ec^7TEIbVW^7[6YEMcZ7e`>>YG^7hTTNRc^"
    "86h`2i3^87jXNAO^886c5UW]88jV^RW^8>FZR^k^8?Alj9o^8GRVRUO^8P:@JB[^8k4H5VG^"
    "8k`]9]W^8le1MBOR92HSJfg^98=>jbc^9:6G2VW^9;mRm^O^9A[OjZk^9_AEJBc^9o37:aC^"
    "9oD2j]?^:6=ERV[^:9cTnV_^:<=efYG^:<AB]aS^:>O9N1k^:FKiZR[^:MKfZIK^:TnDb=S^"
    ";1GX5nW^;2QjnZ_^;5WSiU;];7l;2bc^;>4=mNC[;B:DBUK^;M;MNQ?^;O=XAUo^;[nBbZ_^"
    ";aJX:1o^<38SfYC^<DXhnJK^<IJ4:RS^<R`4jQK^<TC6bEW^<TgA^IW^<W4V=Ug^<XX1Z:W^"
    "<c61Nbc^<m@K6bc^=7IYMYg^=7QGUV7^=9MibIO^=>:Ink3^=ChXE]G^=L4FnQK^=SQPnZ_^"
    "=WSpZRW^=YZ3BQS^=YjAfES^=`P?FAW^=dD`mjW^>1e5QR;^>9[gj:W^>Kao^QO^>OnKbV[^"
    ">k^E9F;[?6]VF>c^?A1;AfW^?E]>>QK^?Fh>j]?^?M_Bn:O^?UW[^Z[^?`k2^Z[^?oHXQNO^"
    "@8kGJVW^@9mdQQk^@BQ`fUO^@G3U2Z_^@MYNjQS^@PYlIV3^@QC0^B[^@^gf6]G^@ap3R^_^"
    "@eX;2QO^@gF4=Qc^@lLeY]o^@m`8BJW^@mm;^RW^A3Thn6W^A418nAK^A7BO^QK^A?N::BS^"
    "ABE9JIS^AF[onfg^ANmN6IO^ASK[ZNW^A^FZ6UO^A_[4ZZ[^Ab`jIQ_pAfH^f:W^AkS5fbc^"
    "B3cK>VW^B5kC>IS^B8aUZZ_^B:iK>R[^B>]g:IG^BKpoBUK^BL5E:QK^B^SBUJG[B^klZF[^"
    "BdOg:EO^BjcKIMk^C4^KF1O^C;ZI^a?^CGQ4AfG^CYTHNR[^CeXG2Z[^Cf>;:NS^ChYURYK^"
    "CkWUf9G^Ck]dV>[^D1eAVMK^DFlVRNW^DVp>V2K^Dc0GnRW^DgH;2UO^Dj4V:e7^Dm6mM^W^"
    "Do5F2IG^E0d0MVC^E:5oeUW^E?NcjZ[^EFcDNAC^EXP0:=S^Ec<mNZ[^EdoaiY[^EeY:jNg^"
    "F6hfJ9W^F;=a=NG^FFc]jVW^FHaE>RW^FPE5]^C^FRBI:J[^FRH1UUo^Fa@iEYk^Fc?H>IO^"
    "FcZSmR7[FeJOS@c^FeiN>AG^G<p05]W^GG<GnVg^GMbgaQS^GlT[:FW^H57`Ffg^H6Ap^YC^"
    "HF6k]YW^HFITBJS^HORBB5g^HYCEnNg^Hb`BjMS^HijeieS^HlXd>Zc^I87IfQK^IBJ`j9_^"
    "ICJoZIS^IY>@JYC^Ipg>nAO^I^>VBBO^J2M`n>O^J7iNjV_^J>Rb^]G^JDHmB>[^JHi6V9K^"
    "JHm:B5O^JNM=>QO^JRKNZZ[^JS7=UQg^JXX7n>_^J^1h:jk^JdD]6VW^JeF?Uf?^JejJRNg^"
    "JhYRnIK^Ji@W:Z_^Jmd9MZ;^JoDTF9S^K0=d1^G^K>ZiN>K^KRVZbR[^KVXMQMc[KXU[Va?^"
    "K]7Ob^c^Kmmd1M[^Kok5ZYC^L1SH9^?^L3d0NFS^L5hiV]C^L6RgFEO^L=InmV7^LFL5ffk^"
    "LFhP2MS^LI:o5EkZLO1TJV[^L]79>UO^LcL?ZV[^M2pC:1g^M8RZ2QK^MELLne3^MHfDaZS^"
    "MJ2?FZo^MY`Qb1[^N1?7Ne7^N4@<fMS^N91eMYo^N;6Y^Rc^N>8kRUO^N?116:_^NDnPMYW^"
    "NF6K6MK^NImjVQO^NQ@@=N[]NYeMfV_^N]:`a=_^N_LNm^O^O56?VEG^O;pAbNS^O?eUBBW^"
    "OAa_F:S^ONRNiU_[ONk8Z]G^OPcM2^_^ORY<FRS^OUH5UJ7XOZ40f>W^OafXbB_^OdnmQZK^"
    "OhAW6YC^OhGGnAS^OiGQEV?^OoU`EMc[P>>=Z5k^PD4`VV[^PJlEF2W^PL0DAIWVPSJfFY?^"
    "PXA6jRW^PZh`bV[^PcbGJEO^PkB6>MS^PlpFZ>S^Pm8bnV[^Q9=KjY?^Q;3pYVG^Q=XX:R_^"
    "Q>fJajS^QAnh2MO^QL]RRBO^QO6<2N[^QRIcnJc^Q^=V>^c^QhKlEN3^Qi3JZZ[^R=2n5bS^"
    "RFXVj^_^RFnj]mS^RG^I69O^RO<oaic^RRQOnJS^RVE[BV[^RX_l6UK^Rp_@:R[^RfH]nVc^"
    "Rg?62JW^RimljIO^Rk]<9^O^RneYNQK^S1PK6Y?^S7X82o7^S8[fij_^S>J=n9S^SC<K]Yk^"
    "SFjYY^;^SK8EZFG^SNmZ>IO^SZ7e6QS^SfnpfF[^Si]SbQ?^Sj7lVRW^T;=gRF[^TGko=n?^"
    "TJYhAYo^TKD1jAO^TRScbES^TT@RYQcZTUpImN?pT]lk1UW^Tcbo6BW^Tl036AK^ToB;:IO^"
    "U0e=6AS^UOhijFO^UW3Yj9[^UZpPBfg^V8]JIUW^VC`0bUO^VIO_BZ_^VIl8RAW^VOIR=Yk^"
    "VU]>2]?^V_O;:Z_^V`UK6:O^Vf5Z1Mo^Vo9MFQ?^W3cK^^c^W52hNaC^W:1ZJ5[^W<aaiQ_^"
    "W@dj2UO^WEEZbJ[^WF_b66W^WPXK:B?^WSMi]V3^W`L;]M_ZW`LK6UO^W`^[6MO^WcJE>YG^"
    "WfE<jRC^Wjln:`k^Wo>`2ES^X20h5eS^XCPibM[^XF6fiR3pXF:<VIS^XW43AQc^XWW`NMO^"
    "XZ26ZMO^Y0PBUN3RY13obIK^Y1OCnFW^Y4>LJAS^Y6Oe>VW^YCh:QVC^YFSXV9S^YPS?>AK^"
    "YU:[VV[^Y]5gN9O^Y_g2bFW^Yf1OB5K^YiAg6=k^ZB^6Ij?^ZO^RVB[^ZOdX2>W^ZWKQNJ[^"
    "Zd<YQiC^ZoCB66S^[2ZBVMG^[71DB2[^[C3h:=K^[C_Kmn3^[UW8bN[^[V<KZQO^[];[Aj?^"
    "[ejYZ=O^[i]Gb^g^[mHOB=G^p=p;:UK^p@_;JMO^pAF0nUK^pBB@BJS^pNCQEIc]pPn1V6S^"
    "pURd2QW^pVm[NF[^pXJNAic^pjAQ:Zc^]1gc9VC^]4i:^V_^]5cpZN[^]8jHYA_R]CEE^AK^"
    "]FVpN]?^]IY3aZO^]LEn2YG^]R1C^=O^]fi8^Z[^]o91ZFW^^5e7:]7^^@k?eQk]^BD8QU[^"
    "^DiT>QO^^I;U:AS^^OAFMmo^^SJlZ=[^^VJ4jMC^^WGd>NW^^W_gMVKp^iTfMF7V^nj7iV;^"
    "_4eP=VC^_6JebZc^_7cCRV[^_?aNRES^_H7df1O^_L2N>R[^_MSZBVW^_b:[B]G^_c^N>Z_^"
    "_djIR>W^_fE`FUK^_lMg^VW^`5bGVQO^`O>ViYW^`RcbnUK^`UfM:k3^`]T@bZS^`_KL]bS^"
    "`bY1m]W^`iiLRZ[^`l4HR9g^`oi;ZYG^a1cKNFS^a8HQj9S^a?hbBRW^aB_?:Rc^aJ@TR9_^"
    "aR>e2NW^aRQ0je7^aRalZe3^aT_E:RW^a^lg:9k^akm@=aW^anMmefO^b7BYiQk[bPNpF2S^"
    "bPcabRc^bVhdbQS^bjoCNUK^c17@^QK^c2>l>=[^c5:>=nC^c8ZnBV_^c9[hRZ[^cAhEi^7^"
    "cBLbF2W^cE;YBIK^cHRWRQO^cR39=MW^cajZnR[^ch6b^JS^d0W>F:;^d57afUK^d6:4fRO^"
    "d=]<]R3Zd>EA6IS^dH51i^W^dJ3MY^7^dJOjEQWZdN5NIZ3^dNA9Z:W^dSeGVbc^dWoiN9S^"
    "dZoAEb?^d]?iZ:S^d^KkRNS^d^XnnRW^d^^WVVS^dbn<6^_^doR@^YG^e<fhYV7^e>F[V2c^"
    "eFAU>6S^eFMS1^C^eK4c=^K^ep4RIB3Pep8522S^eanS>a?^efTEZW3^f1acjJc^f=g:eVG^"
    "fFD7B]?^fLg@^2[^fMa=^a?^f]i42F[^fd1QaJ;Xfk[3RJW^g9pg1N3YgBLceV3^gDHlJbk^"
    "gQXEfEC^gRfRAJG^gY5gZQO^g`891Q_]gcDA>YG^gh]XJUK^gjQNb^g^gm1V>>S^h;Z7NQK^"
    "hE9mBbg^hJ8obJW^hWc?mV?^hZ`CjF?^hZ`IJa;^hcpkZVW^hd6eVR_^hd]ejVW^hgNKU]o^"
    "hj9i^k7^hjac5U_[i2`LJRW^iKccEZ?^iZ:^NR[^j;m]6UK^j=[bYmk^jB1<AFG^jKe?BUO^"
    "ja7B]fG^jgCf:RW^jjB?=Mk^k7WibUK^k:nDBFS^kINI:JW^kPZo=jW^kT:>Bfg^kU=m=j[^"
    "k_^QmRG^kfmOjAS^l::8FFK^l:e9>R[^lFh?mn;^lPJV2F[^lUl]2JW^lW_mfBG^l`DOB9_^"
    "lbl]Zbc^ldN5N1o^ldN[:UO^lo5j2AW^m9_<faC^mFZg>^g^mHR9FEO^mI74VRk^mM5OQZK^"
    "mc<hYYg^mgSZJQS^mi?eMMKYn^MERV[^nkkXMR?^o2?DBUK^o4><b:S^o9l@ibO^o;`gim[^"
    "o=7QF:G^oBNH:IO^oBf]nMO^oFPSfIS^oIX6bRW^oK[SVE?^oPEQnR[^oXUZ6g3^ocAhF6S^"
    "00001n3P079b=R3P0]D99Qg^0`22BB_^0n;g1N3^13jiiEoZ15EY=R3^1CNP9ak^1P3NEmc^"
    "1mbMAN;^24l?MN?^25JC>=_^26Fnaf;^2VcfeR7^2YQ_nBS^35mU1nC^3B[p]f3P3Ppn=V3^"
    "3hf3^?C^49]aQZK^4?LdMF3[4@gS]Qo^4aDKa]O^4b_;5j7^59DGe^3^5@N:1R;^5C<39b3^"
    "5bEaFR_^6D>FQ>G^6ImIIEoY6KH8]Qk^6p>h]b;^7Jn^mIk^7LINA]g^7O7GF5k^7lfFEU[^"
    "8L04Q]o^8X^<=j3P8f_M]Qo[9>hS9jS^9O`A1Qo^9UOCmMk^9Vj3=Yc^9e2j9ag^:OFgER;^"
    ":S6=R9K^:VPYQYc^:WkHb5S^;8H@e^?^;OfGNAO^;Z@emF_^;bJQB=W^<2AH=V?^<F_i2>[^"
    "<QK6N1g^<[B;Qb;^<a1>MMk^<bKm]Uk^=BheaMk^=Zhaf:S^=[j>n=O^=b2T1Yk^=gViMn3P"
    "=n`[]R3P>Tk2YYo^>XZHjEo^>eb`QJ;^>k>R^=[^>kQcIMg^>llR]R3^?;5IYj3^?GZGej;^"
    "?gnpZ9o^?lS8mRC^?mmhAfC^@NJ`EU[^@R:6VF7^@d^@J9S^@mTNQn;^A:BV=b3PAHCg]Uo^"
    "A`Lm>2O^AaNJFEk^B1D[1ZK^B42T:=S^B73]mAkWB8NM=Qo^BXGkj6k^BXkEAYO^C0b^69c^"
    "C0kAEZ7^C853QR;^CYlZf2C^CZn7n=k^CmRAb9_^D;e?mBK^DBo2=Qo^DQgYR6W^DSeb=b?^"
    "DdKcJ6;^DjBK^Ag^E<fUR1W^EBUXMIk^ED0Ga]g^Ea;mBBk^EdM?eQg^F9V_N9_^FCVn1]k^"
    "FPE5]b3PF^FG=RCZFcb9J=g^G6FC>=_^G6OLYfS^GGG:QRS^GM6=MB7WGNPl]Uo^GZ[Zn:S^"
    "GpYcYak^Gm?db6O^H36M:I_^HFm`aV3^HN7S1U_^HORBAmg^Hion^>c^Hoo:Eb?^I<T8R>[^"
    "IBJ`j5_^IQg_MJW^IY1QYN;pIihA]Z3^IlV:f=[^JRi51^;^JXX7mIk^JZ2g=Uo^JcOpJ:K^"
    "K63f>6W^K:O_AI_^K;jNVQK^KRO[En;^KYYMQV3^K_=bmn3PKfGU=R3PL2d0:B_^LEH9nFg^"
    "LLQl9a_^L]IZ1JO^Lc8piIgpLdSL=R7^M5J<>9_^M?AAE^7^Md:2MIo^MeTaaf?^MlC]f2G^"
    "N>ggZJW^NF1YeaS^Ne;H1f3^O1iO]f3PO;X1V>_^O?ja=Uo^OX3fYjK^OhkTQVG^OnZWMEcZ"
    "P05F]Qo^P>>=Z9S^PhR:eZ3^Po[m1Qo^Q57_>>W^QQSTEn7^R3L9MNS^R:Uk]R?^RDL2nB[^"
    "RKL[]jC^S4MO25_^S:<QmMg^S;WAA]c^Sp49EQc^T1=Xmmg^T;=gQYg^T=k`ZN[^TGko=V3P"
    "Tn6F9bG^U>n41VO^UD]6mF3YUF7f=Yk^UT@]9^3^V>TZAN7^VE^LQYc^VG9;aio^VaVh=jO^"
    "VgV3eV?^WF_b66W^WINXmNg^WSMi]j3PWaO;=]k^Wd=4Emg^XJOnQZC^XP?1MF7[XQY`]Ug^"
    "Y26XaUW^Y3QH65k^YJ6Tej;^YQ@G1V3^YVdpMn3PZD8eYa[^ZU0SQFK^ZZ_VIIg]Zp:E]R7^"
    "Zm15]mg^[MDdF5W^[[`kmEk^[];[Ab;^p6Na:2?^p=XSE]c^ppbAQb7^piPI=j3P]4@H>EO^"
    "]7QZ]McZ]FdR29S^]OZ`9jK^]`RN1ZK^]fAPmAcY]gp@=Mg^^5e7:5_^^CT[n=o^^`94EYo^"
    "^gBfQQg^^m`5f=S^_@D?Z5[^_I:Mej7^_k32mQc^`2<e9Mg[`<2lN6G^`=4IVMo^`C3U=b?^"
    "`OXSJ9S^`l4HQj3^a1cKMQ_^a3>:aYk^a3mk:6_^aLH]F9o^aS[2aN3^a^lg:>7^b2da1Yc^"
    "b5RZ:2C^b6T7BB3^b?Rh]V3PbI8A69_^be]?YZ3^c6TmQV;^c<D0IEoYc=^_]Uk^cEhK2Io^"
    "cKgVYb7^cXLTfIS^d6;SaJ7^d<alV>k^d=EF1Qg^d>`5Af7^dU<^b=[^d_<mEQo^e>F[V:[^"
    "e?H8^Eg^eA5RMNc^eK4c=b3PeQlBR9[^eY64]]k^f6AZB:S^fB6h1^G^fGejmIgpfHed6:W^"
    "fI@Z=Uo^fNpLNIg^fi]RAQW^fk8AUj7^gA]NEb7^gEUn2>g^gHg@QZ3^gNKUmn3PgX:7fBC^"
    "g^0`>=_^hH<:6=[^hLWM1FC^hRFOiIk[hSa?=N3^hZ`Cj=c^hdWo=f;^i?5[Z6[^iQYeR:S^"
    "iSGeMI_^iTbTa]o^iWPMfMW^j5?Lef7^jNIoN>c^jTI;1]o^j`n9BF[^ja7B]j3Pjo8T=VC]"
    "kGAYYnS^kQ0;R=W^kX9GQRC^k]hJMJ7]k_C9]U_^kmL0Yik^lGi]62?^lW_meV7^lZMfjBW^"
    "l^i`1Uc^l`DOB5S^m@aGEeo^mW>0f:c^mbYlMFK^mic^YR7^n:ZN]^3^nYd<nA[^nc[B1f3^"
    "niJDmMg^nje4=]g^oCoVf6C^oKAlAI_^oP]^R6S^ocAhF6W^ojKZQYg^00001Z;^0593en?^"
    "0:l;34o^0Ab3nno^0^`@^6[^0nRUV9K^1Q=XURk^1pj_N5o^24W0B0_^2TJbf^_^2_AM>>G^"
    "3<gB^6?^3B[p]j;^3LEQemc^3`AR>9_^49h3K77^4?>0NAO^4bX?nJW^5Vacino^5j81ZA[^"
    "64b`>J_^6Cg96i;^6LT=e:KS6_1>V9S^6kcL]mk^70Qepn3P77MSZQK^7<:p2CK^7J[X6e?^"
    "7Qi]>=_^7ee]V2G^8?l>Nfg^8FJ2ibc^8pODMg;^8pPU38k^90fKVJ_^99BQQno^9@DZ^:c^"
    "9GR>mE;^9OI3[8k^9P6oVIG^9PKSZ>_^9p^1Vi;^9c^j=j_^9jS969o^;1GX66K^;OPQS@c^"
    ";^Kp^V_^<QI96i;^<`bJR=k^=CQCj8c^=D<Z2F[^=Ld0^j3^=bp3>ec^=gViMj7^>^Xm[>G^"
    "?17INN[^?;_[?77^?@UXV9O^?]_66;C^?_9j_33^?eK[>no^@3N7>MW^@aPXO33^@hbEk93^"
    "A6>:EIC^A?1U6YS^ADjgnjk^AfjBf3?^Ahd?KCC^Ai6XmAG^BH37B0c^BXcF1A7^BZ?9N:?^"
    "C2D_G:[^C=YHmio^CGA:VeS^CdM9k4o^D8MH333^D@06b:C^DONEiek^DcJF>1_^Dn2X3CC^"
    "EIPV^UC^E]LW6:C^Ee5]j8g^Eljf>2G^EnHJ^^C^FPE5]io^G?98MM?^GDDk3:G^GR[cNB[^"
    "G]D5?GG^Gb:2VEO^H?CP6GC^HMdL:i;^HU2Q>EW^HWNABaC^JJ[2mLg^JQ96Qlk^K;cSR6C^"
    "KZZNAB_^K_=bmf7^Kj9mni;^L>5nFm7^L]2LZm7^Lh^BnF[^M1pHjAO^MKnLb0g^ML8RN1k^"
    "Mk50^9g^N3_0nV[^N?116FW^NFZ7j<g^NNO@>2_^O1iO]jC^O;SDf=_^OIWhjm7^OXpbFFW^"
    "OnKcN9[^P4@=NF[^Q92[C<g^Qkk9kH[^R`:CV5g^S79P2RW^S>Q]>UK^SMi^EjO^SdQ_^>_^"
    "TGko=nG^U6`1mY3^U7odBaC^UmplN5k^V2=A>AO^VJ3W^Z;^VLYJ^=k^VTl:V=C^V`UK66[^"
    "W03Z=fO^W;;3kKK^WMYO^FW^WSMi]Z7^W]7^f9S^W^gpmM?^Wm:hg4o^X:A<FFW^XBAlMM3^"
    "XP0=R=W^Z`E<N:O^ZdU=R8c^ZjmN>no^ZocKUmW^[C_KnAW^[[Me6m7^[b[j>EW^pF69^>[^"
    "p]cBESC^p]eQ_8k^piPI=jG^]A>bJm7^]OFU:lk^]QKD=fo^]f2pnIG^]kg6n:S^^ILlN6C^"
    "^OAFN1k^^lg;mek^_DUU:i;^_o=i^B[^`>p8jAW^`?m>:??^`N4dQG3^`ZhOZQc^`[eVFJ_^"
    "a1TWRA[^b?Rh]j7^bTQFbRS^c=3Y6jk^cAiVNZk^cLQh?33^cQGeV1k^ceCen1k^dD@D>=g^"
    "dfo=V=c^dgZS^J_^eCdUapo^eE@I>R[^eK4c=j7^ehPS34o^f[S7FBG^fk1FN2K^gNKUmj?^"
    "g_V1>?3^gfOJNno^hL@?W4o^hPbCb>G^hYU=Vi;^hbTG_??^hgJE65o^in>d62C^j=]3>6;^"
    "jXV9j7G^ja7B]mg^kXdZ:Fg^k^X36no^kcN0NBK^kn6B?77^l2l?Uag^lA3en>S^lFh?n1W^"
    "lQPQ_;;^ldN5N2;^m5pB]lk^mHSWVAW^nJ?2]mc^o=7QF:O^oB@U>Jc^oLU`QjK^okL[AFo^"
    "00001eo^00Y:i:GR0WVm6ik^0ZS6bAK^1W<AG8k^1l@A>]G^2<TS1Ng^2X@5JbO^2^^>:A[^"
    "3B[p_:O^40<kbNk^498pbG3^4CH>^1O^4Q<B1nS^4daU^B7^5APY:a;^6LKeNG7^7?HEc33^"
    "83oTb53^8Dp@Alg^8I:9Bjk^8TZQo;;^8cepZYO^8df7bVW^94RH:Ig^98KKN>O^9JaJZRc^"
    "9h23N9c^:O1D1j[^:TjIBbg^:VYYfm7^:`5[>J_^:i1?:6C^;1GX66O^;@BX:MO^;S`f66O^"
    "<0PbemW^<bnS^2[^<i3fV0o^<jJC:Rc^<lb^5ho^=4]1n=W^=FG6E=_T=O0IR;7^=QL=6=k^"
    "=_S[g;;^=boYAnO^>2MM^=S^>?pOEmo^?gJ[f1O^?kJG2I7^@<BpBYW^@K?^^bc^@V<g^0k^"
    "@]B_6Bo^A55_FVk^A6>knjk^ABQdnjk^AOS9^6S^AcC5:U?^Ai6Xma_^B3l<:>W^B8ZYf=W^"
    "B@_]iB_^BVon^o7^C9ghZ1[^CJUY>6[^DbIl6FW^E0lTeS3^E6bWJeO^E9RdF:g^EaMCFCK^"
    "EnE=R73^F4DiR:[^F`Tm^bg^FcB2B5G^GIKW:J_^G^?Nn1W^G^hYe:GTH;R^^AW^HB0mB:g^"
    "Hf12N1[^HhoRZ>O^I7;DbFc^IegMZMC^JJ[2n5[^JZ?3fA[^K0k;[:G^K2Y[BaS^K;@DN=c^"
    "K_=boGG^L1W]YmK^L^BAEPk^Ljb>Zj?^M<YHJE_^MahDZa?^Mg[hNB?^MiVm>>_^MjGRjm7^"
    "NhgT^e?^O2jmXj3PO8M8:IW^O>]T_4o^OE;=N>W^OJ^h]ES^Q3BSZ6C^Q5Gfk5c^Q@J`n7?^"
    "QZDMUjK^QhKlG;;^R=BeRYK^RDT9]m7^Rd?0313^Spd^NIO^S^`AbM?^SaDff2o^TLF>aMC^"
    "U<K@N>c^UFlIJFS^UG]Y]n?^UZN8V:W^UdL];13^VOVJ>>k^V`pl20g^WSMi]j7^W[W;:eW^"
    "X0<m:A[^X@iXZm7^XQVD:mo^YWF7j=K^Ya?Q^Bo^ZU<`60o^[0N_>6?^[<h3F1O^[D5?ai7^"
    "[PeknBc^[pVVR:c^[g7_N2O^p>UXV2?^]`a[Z^c^^a]d2Z_^_9cL?:_^_P[^Yng^_ib=ZI?^"
    "`E`5eIC^`HD1RF[^`VLaEQ3^`[iE>NG^`aQh:9c^alQ=b=o^b9bTR6C^bCSTnG?^bVK;:F_^"
    "bhJ:k8k^c6a:6<k^cMMAkKK^cN3N1jG^cR39>67^cVXhb2S^cZ<J[1?^cfBRalo^dKbAOGG^"
    "dLQ`B0g^dY1]ViK^doS:nI[^e9<D1ig^e>S?9Q;^eFImC4o^eFMS263^eUkGJEc^eXW1g4o^"
    "fF93NFW^fFiY:e?^fX>Wj^c^f]VlVBk^fhOGVB_^gR_>>;;^gT?;26k^h9;<jAg^hgmHaQ?^"
    "iV[KBno^iZ7Hb2c^iplg>J_^ib[1bA;^j6d>f6K^jJK:en3^jOEUQ=WYjbOE:aC^jiU<R8c^"
    "k1:oFRg^k<9=Eeg^k>CbR5K^khGM:IG^l:U]b=7^le@M:YC^lfi6NVS^lmF[O33^mB]5iOC^"
    "mHS8NR?^mP1U^Z_^mXmF^RW^nA=7ab_^nhB:JJO^o52SFEG^oA]HZ1S^op0`>33^oaWLJ>S^"
    "00001jG^09Be^FO^0B0`R5G^0D:J:NS^0S^0FIG^0V59:6C^0XE@R=W^0`GFJ1o^0cDR6AK^"
    "0hQ9NJk^0oMmNC?^13SAN=?^14^[QN3^15pk6BO^1<`aIiS^1>Jej9O^1E@QBAW^1HmWae_^"
    "1MBW:1c^1N?d1NO^1N[PIbW^1QnXn>S^1Tg31Uc^1W@n>YG^1]Fbj2K^1^p`UjC^1_i;6AS^"
    "1fA<MV;^1fK`6A[^1g?L2F_^1nCBEQk^26c2BAW^2>e8:5c^2A4Ii]G^2CQ9ijO^2CcJZJk^"
    "2DY=fUG^2NiCj2K^2P?AUj;^2Wc]MV;^2]JSfJk^2dEFEb?^2l4EfA[^2lGL>9G^2m]Ij9k^"
    "2ncFVRg^31DeiJK^353Zf2O^35_Oae_^35mU2:K^3;QNAj?^3AabQf7^3B[p]j;^3IchImg^"
    "3MmNV1[^3TCTf>W^3XoVZIW^3]im>I?^3_?jjU;^3cg;6Q?^3gB0b5[^3k=KnNc^42KemaW^"
    "4:nQJFW^4GJHAek^4OLN9eO^4PbKfAc^4UIp2EO^4W`db2;^4XdQ^1_^4Z0l>=S^4]_`j^k^"
    "4j<e6Jc^519Y9nk^57HVbFC^58li>9O^5@6QV1W^5@no69o^5APOG;?^5JYCI^;^5PG<66_^"
    "5aTfbEO^5bp:6Rg^5h7KbIS^5hk7^J_^5jOJ9fC^5nh_2Zc^661>2JW^6@Pcb5g^6D52f1O^"
    "6EK0R9K^6EO6FB_^6Id5b:O^6PToR2C^6Qjm=b?^6RG=J0c^6YBjFFS^6YOI5R;^6]nl:U7^"
    "6_6?N>c^6cIM^NW^6dQQ:N;^6n37j9K^6oI5VMG^70O2BN_^75WSbIC^76_FR2K^76mQN=K^"
    "7==9ij7^7Ai;^BS^7CMN9b7^7G6VIN3[7OY:=f_^7TFNRQG^7_UXf9W^7`kVRE_^7eRf^EC^"
    "7li7ZB[^8ABcf6c^8F3C^VW^8PZOaeO^8Q89b9_^8RIEj:[^8W5GZIS^8Xg9BUC^8YLPN2W^"
    "8_KLR^_^8khPb>W^90QVm^K^92eDb>o^9?VgJ:W^9R2g^B_^9_7M^]G^9b47mbG^9jVcFJc^"
    ":3D^>=W^:7XIFG7^:>O9N5k^:G6p:QC^:G:b26W^:HAR6bo^:KOaJ>O^:R@[>6?^:SVXifC^"
    ":YVbB=o^:_ZWbM7^:`ak:>k^:jPh2;O^:o^cV5O^;14a>9C^;2:]nNg^;8K2:2G^;DV^>:_^"
    ";E99ef7^;QDeinW^;pFmnIK^;bWB>E_^;g>RJ=G^;nTcF>K^;o?SRFW^;o@XAik^<=eC:IG^"
    "<BnOR:c^<Xa3FI_^<eO:n:[^=ZhafJc^=lBO2Vc^>B_E1V[^>HbGf=C^>JJ`5ak^>SlFf6K^"
    ">[BMn>7^>aFCN=O^>bMVbBo^>e0U2GG^>hpTJR[^>iHIEa[^?1JO>9S^?2`LjIC^?3fIVBW^"
    "?5Jp21c^?>]n2BK^?FBIj>_^?RhdJ=C^?S0QUjC^@0@Nn:O^@T<JbJ3^@U`]>>K^@ZL^nQW^"
    "@o8V2i7^A2S0Z2;^A9Hp22C^AVfdFIG^ApPeZa?^A^hjB9O^AeKOAb3^Amn:^_7^B6p5R9?^"
    "BHIEFM?^BPKK>1[^Bpn9ZFk^BaeTYf?^Bd9BNBk^BigZQi[^BjH@6R_^C36:j=g^C4L8VIC^"
    "C5R5B:O^C6d:>6O^C76G^1g^C9kfB9O^CAml:AC^CB@<iik^CFl>^>[^CGn5V2c^CSH5Ub;^"
    "C[J;M][^CjUi^=K^CkNG>5o^D1l:Z:O^D3PM5j7^D<c_6BS^DDjVQic^DLlpIi[^DT6RR]C^"
    "DUh6J^C^DVp>VBS^Dp8JZE[^D^>;RY?^D`8WN:G^Dd:PR1W^DnF@26S^DnTJnAK^E6M7MN3^"
    "E7ZJf1?^EP7YEMoYEXRP2=G^E`6kj5W^E`TUj5W^Eh91bAO^EnSiZ0g^EoYfFRg^F4BM9ng^"
    "F8Ga:A;^F:QJbFK^FAUA69O^FJ50nAW^FR76f5c^FS4C]NK^FY[R]aW^F^YeBNk^F`6JUeG^"
    "Fedn6Bk^Fi67Q_?^Fk5p9RG^G37b1Q_^G67d>IG^G7=`j:_^GCYWb5_^GCkhUbG^GHEYUnO^"
    "GHWjFFc^GIYa>Bk^GS]cV6O^GpX=9]o^H1;kj=S^H1o4FBS^H3WfB:K^H69EUV[^H9h:QfO^"
    "HE@DQf?^HFVB=j7^HNXH5ik^HORBB9_^HUb>>]C^H]d6FEG^HadC::O^Hb^LjIC^HcD1bm3^"
    "Hd4JRIC^HkJ[Mj;^I01kZFW^I88c9Z;^IBJ`j9c^IL>gmig^IT@mf9K^IUVkRES^IZ>;^EO^"
    "I]Y1J5_^J1ER2N_^J5n8f2g^J=aHj5_^J?XY6N_^JEcNb5[^JSbbR5c^J`EPnFk^JgPYbS3^"
    "Jm_WJFO^JoCief3^K7cOj=G^K8iLV2_^KHiRR9S^KJ?P=i[^KJCV2Bc^KKELjW3^KNXUN>K^"
    "KUIO>:C^KV_LijG^K[F]5bO^KbcKfI7^KiF0f9k^L2gWVAK^L5CQn>S^L:F>QFK[L:L3NI?^"
    "L;Sf>2S^L;b1:MC^L;kcNa7^L<@NbF_^LFl09bO^LHAmef?^Lb7]RJg^LcOnf2C^LdJ8R9S^"
    "Le`6>EG^LknTIeS^Lm6G9^K^M1]WF>?^M8l1AQ[^M9dNab;^MSl52Rc^MUNoN5O^MUlYN9[^"
    "M[igFEK^M][XnAG^MgZ6fg3^N31=ZF[^N5F6YUk^N7YdMng^N=;E6?K^NEM=nB[^Nb1<V2_^"
    "Nc`fRAo^NfhWUfG^Ni<EN[7^NoKC2FK^O9O;RAK^OKk;f5O^OKoAZ>[^OM18RRo^OPDA6BW^"
    "OQ96>=k^ORbIV6c^OW5:j:C^OXK8UfG^OdO7N97^Ok1pREk^P4SCB=K^P6]06N_^P6o=VBW^"
    "P8SP65g^P=?Qf2?^P>>=Z5c^P>QEjQc^PHW[ebS^PImYQf;^PJf4ejo^PJlEF:G^PZk`:Z[^"
    "Pa;MZIG^Pe;ZN:K^PgKajA_^Pi=SRAW^Pnb2e^S^Q;P:Mj;^QBYbfAK^QFQe>QS^QGbo=ng^"
    "QQMONJ[^Q]US2E[^QiEbNo3^R22H6N[^R4piF6[^R9EP::c^RG8iZ>_^RI:f663^RJL2>BS^"
    "ROP9N:o^RZAi:97^RcphAf7^RhTCA^7^S16n^FS^S9diR9[^S;:g>5S^SMVgQeS^SNpd>B_^"
    "SQolb:W^SX`fR6C^SZ6d=f7^SgB6N:k^Sl]H:Ec^SofBYa;^T6>nj5S^T8ZiB>O^T:?;^9g^"
    "TJCGQn[^TNJLnbg^TS[K21g^TW]D6E_^Ti7MRAO^U0M^M^S^U=;f9b3^UY0jNV?^V81Y2B_^"
    "VHdUBFo^VL7]fFK^V[[D2EC^V`UK6>K^Vc]Ij5g^Vo_pY^7^W2bZFFW^W:1ZJAc^W<fRj=S^"
    "WF_b66S^WM=e2po^WSMi]bC^WU?jj1W^Wg]2BQ[^Whmb:?3^WnI3fEK^Wnp:=ec^X7jZV5W^"
    "X:FTn:S^X>`EnAO^XB<2j^_^XFbKfEG^XKo3:Jg^XX<UAb;^XYHobMG^X`>[9mK^Xd4Cn;7^"
    "XdWb>Rc^Y0Bfj9[^Y29J9f[^Y6`ZF>C^Y8Dlaag^Y:2@E>7^Y>gQab3^YI_6=io^YQa<5]c^"
    "Y`ljFES^Z3:_^B[^Z3HjZAG^Z9]D^N_^Z;AW9Yk^ZJP@nVo^ZS?12MS^ZpeZ2fg^Z]Fo^AC^"
    "Zd]@Z6S^ZdkKVAO^ZfK;W0o^Zj0EaeC^ZkkZUac^ZlmQN9W^[1KHAbC^[4NF2JW^[5::m]S^"
    "[?EjNJG^[J=i_33^[NiPZEK^[SP`fEO^[ScKBe;^[^P2J=G^[aYSNB_^[iR:NEO^[jYMbC7^"
    "[oj;eQk^p04_NA;^p7lA]U_^p<2@V:[^pIKDEV[^pMZ^fJg^pP2SIUc^pQaIN6S^pXRCB2K^"
    "paLpeb3^piNb]U_^pk8g:5[^]3e5b2c^]60KV1c^]:meARW^]>pZ=jK^]@S=Mb;^]J4d=f;^"
    "]KJaij3^]Ro=aN;^]bXV2MS^]gRlR1O^]h8QNi3^]hhj>EC^^0?;9b?^^4fKFBS^^5e7:9[^"
    "^68?JM;^^;I0FJ[^^<mBe^7^^AT`bE;^^L;lZ:_^^OAFMmo^^OO5:FW^^Q3GYm_^^Y5MRIC^"
    "^ZKK>MO^^_2[J=G^^bMQ65_^^fHlB>[^_373mnS^_6:1^JW^_:bXRBc^_BUhUmg^_DM8bF_^"
    "_H@05e;^_JWnN5S^_Kml:=c^_k=f:EG^_lE9NO7^`2T76BG^`48IQi[^`6LXVF[^`OFJN>S^"
    "`[SlUb?^`abJb:?^`kjI62W^`l4HR63^a5PaN:[^a;pD61o^a?@S:AC^a@HEj2K^a@VPf=G^"
    "aB>i5f;^aGlab6?^aK`Of2G^aM6MQjC^aTZiIV;^aU8SImo^aUe;nJW^a^lg::7^a`P]J63^"
    "adDAZEO^ai>X>5O^ajTUjMC^b0c469G^b1jfenG^b6R72>7^b=4p2F_^b>XnMak^bC=KZ^g^"
    "bZCO:5[^bZa9:5[^bp76fEW^b`^G2AO^beEW>=K^bh4WnFc^c4b_Z:[^c7e]F>c^c<ND:O3^"
    "cAiUeaK^cKf05^K^cZBmf5c^ck]7AbK^cliQbAO^cn0e:No^dQ26::O^dRZX:^c^dU8`b>[^"
    "dZBn2]?^d]?XAjK^d]o[b=o^dcN6N67^dnP>R1S^e1XSjAc^e7<M5nW^e8do62c^e9Gbj9O^"
    "e=Gob1k^e>F[VFO^eCjTab7^eF[A^:O^eIXMI]g^eK4c>2;^eNb9=b7^eVC625G^eVFU5^C^"
    "eVd?61o^eZf8:IG^eb<I2>[^eeomFEC^ejjCj=S^el@AVMC^f3VRN2O^f>`G^F_^f?L<YU_^"
    "f@DZ9b3^fg1Bj=G^fi`CZ:_^g6NKB6K^g>9of>g^g[nYQm_^g_6Hem7^hR]ab6O^hWlW>F_^"
    "hZ`CjBC^h^kCifG^he9b66S^i8h8anS^i;3NUmS^iEV@Mao^iKD95ek^iO7g::K^iX2@]fW^"
    "ipQcbAK^ich4^>_^idSiYeo^ig`VB:[^ilUoR=_^imkm>EG^j4@_F^_^j5B>9nK^j@L3FJc^"
    "jB0Eef7^j]eJ6ES^jkKoAj[^k8:6mnG^kC1[J2G^kPl=R>W^kW32Qb;^k`Oc^EO^l0@i6I[^"
    "l4T<Eb7^l::8FJW^lBN^NJO^lFh?n5k^lR2D^MC^lTIMN6G^lZ4JV9O^l`DOAmo^lfeMb6c^"
    "m1gUfA;^m3=SR=G^m3PYie[^m:SdMnK^m<_:B1S^m?;4Z>K^m?bYfN[^mCTeZEK^mGAl5ak^"
    "mKVkR9W^mLodab_^mPcRf:G^m]14mb3^m^=ONEO^me3:f5W^meS`JJ_^miLAjNc^moWXjAO^"
    "n57FV=O^n=9LMiW^nB7_2Rg^nCp1Mao^nE]2Vfk^nNSUif7^nVU[aY[^nfYgR5k^njHZ>AG^"
    "nm7Zn>c^nn[mIn3^o35BBjk^o7o?JF[^o8=JF9[^o=7QF>_^o@66eac^oH8<^9[^oLAbj5W^"
    "oRWi>6W^oVS`ZIg^oYI[fMO^o`g2>UG^ob;OJEG^ocAhF:W^oi_kBMC^00001b7^08K8^E_^"
    "0FQ]9Bg^0O6>W77^0_mlMNk^0`aG6RS^0eRh6:S^1X0SJ2K^1`[3RQ?^1`daZRW^1fJ6JBW^"
    "28?3YmK^2>:jEjO^2Ji21eg^2LA=JA_^2SWWmnS^2[:;J@g^2c9Z:JK^2j9E6F[^303M6JW^"
    "35K7^N[^35mU2:;^3;]nnY_^3B[p]ik^3Q3>JZg^3e5=^A?^49Q8MbS^4@lej0_^4EBgJES^"
    "4L5hMnk^4Vjk6Ec^4^_6]eg^4iO4jM?^55aZMf?^561;ij3^5<mpZNS^5NpC2AS^5O=ibIK^"
    "5YIQb^c^5`SAUf;^5e^0:9[^5hZ95^3^5mAIB2G^62mFR>[^6LM5N9G^6P7Abjk^6SE:m^7^"
    "6XVNbI[^6]8`JF_^6eiDaag^6ndENBS^7@l]:J_^7BE9iFc^7Ofp:MO^82C6EmO^89T4f9c^"
    "8XJI^9S^8^F@J2?^8e;TnAk^8e?Zb:_^8lLSNAk^90ZXV7C^9;aGjB[^9DII2G3^9IPl^>g^"
    "9UVMb:S^9elafR_^9n]F9fC^:1>TNFW^:>O9N5k^:BS5^AS^:E?3F]3^:WkHb9o^:^[BZAC^"
    ":hRmnB3^:hpYVbk^;1GX66C^;>jLaiS^;Um0Qj;^;V<QmM7^;ZRSMm[^;oI?fQo^<<7GMj3^"
    "<DUIFBW^<EiF>9[^<HeO9M_^<Qb`f5[^<RDn:Fg^<VGoNA_^<X?662_^<dm=aZC^<k?0:1O^"
    "<n`cBNc^=3GTf6G^=8adfEW^=@5pQf;^=Zhaf>S^=a83>NS^=gOD2=K^=gViMj;^>022>IG^"
    ">Y_Jj9k^?K?^9n;^?LWiR=g^?[8oRFc^@5acf2G^@7TdZN_^@A]lbFO^@BOkR2G^@Ch6jIW^"
    "@DBlFB3^@K:KZa3^@QIjRFO^@]_;Z5k^@^82>1g^@b^KbAS^@jPbjEO^@m21>BG^AFZkEaS^"
    "ASW@62K^Aemc2>S^B3lO>0c^B68FR2?^B6bo6JW^BCXp:Fc^BT;f69_^Bcm0nN_^Be?o>:S^"
    "Bf4pB9[^Bi0e=]c^Bi[M^2_^C@Hf6JS^CAJC>I[^CDXkim[^CSnM2EW^CXm:jI_^CYVhF=K^"
    "CZfRQn3^C`A2Uf7^D;i9Amg^D>=lb>[^DP=HBEO^DVp>VFS^DcJF>1_^Dm2fZ:S^E9j`nAg^"
    "E<fUQic^ES==YjW^ET;]FJ[^Ela2JF[^Elc?VAk^EmVkVA[^FI?2BE[^FJ>DZE[^FUm9jBS^"
    "Fp@1:A_^FpbNNEW^FbJiamc^FcZSmj;^G1U@VFK^GpD19j_^GpF19mS^HORBB=K^HVCpUU?^"
    "HhnQV:?^I<N3UU;^IBJ`jIS^IF@2F9[^IFG^1ic^II<;ALg^IR9LnE?^IXZaFEK^I^2gW:K^"
    "IddAn9O^IeVOjEO^IkUpB5K^IlNUIn7^J3^@mjO^J98PnEW^J@LHYag^JBl<^N_^JOeoV>W^"
    "JVlO2BS^K0H^FAS^K7pV1f3^K:1IRBS^K=6f2:W^KZ672=c^K_=bmik^LLnUZEo^L]Nl9hk^"
    "M5=S:>W^M5BVanK^M68OnB[^MD>c2EW^MGM1>@_^MK`>6Rk^MQ`VZJ[^M[Gj9n[^N<kBn:_^"
    "NBeJnBK^NgV4]bG^OeV[F>G^OfKHJ9S^P2Dc2AK^P@J52fK^PG;OFA_^PJlEFJ_^PYCg2AO^"
    "P`W^]j3^Po=W>6S^PoQ]]j?^Q77e6>O^Q<?eIiW^Q>_YNc3^QE_DJBc^QKYLFBc^QPT4JAS^"
    "QUp4]mW^QWCnBUK^Q]B<2B[^QkIEnUG^R:AM6A_^RIlhf6W^RTRIJJS^R`X]>Vo^Rm9k^F;^"
    "S0:P6J[^S@fJIek^SE54>AK^SJd7:6_^SdJ96EO^T1kl^RW^T4oQ2R[^TNSEbF_^TTMMb:[^"
    "TZB;5ao^ThHN:NW^U8^_^J_^UAOD1V3^USjjYnc^V;DkbAg^VFV^N5S^VI1@YaO^VMi5Z9O^"
    "VRP96A7^V`UK6:[^VklHJ@c^Vm;mBB[^W44m5MC^W9O=6AG^W:1ZJMO^W=cRN2[^W@aTBES^"
    "W@c4aU;^WDf]1n?^WF_b5jW^WPGpB>[^WSMi]^7^WWC;:>O^WWGG>>_^WWJfej;^WpK;N9S^"
    "X0_JNAO^X0g6:=k^X5gJb1W^X7ODFQW^X83B9e[^X=MR6>[^XARa:Nc^XJCEMRC^XKTp2QK^"
    "XZLc:AS^Xg]869c^Y4]_NBS^YMEAb9o^YPEf:NS^YV]72M?^Z1>iF6S^ZDUO:IS^ZIUUZa[^"
    "ZPNUN4g^Z`;HZB[^ZmjmJBg^[HSd>JW^[JFbRNc^[S7FiWK^[Zp1JIg^[gl`eR;^[iY421[^"
    "pO`GJAK^pfb4R9W^pi<V^1O^]70c6FO^]OT9F]C^]VN_f:S^]YZS:AK^]hoJ2>W^]i0HZAG^"
    "^5]Q]jO^^6^nfJg^^7NQ>BS^^<VQMY7^^A=aYpo^^IG>MfO^^J91f4c^^OAFN1k^^Pj`REG^"
    "^S:cnN[^^]Xh:6S^^^;ES6[^^ea8R=W^_5d86^_^_:X9>=O^_KmJV?;^_Qj>J5S^_Ti5RBO^"
    "`0Q<>R[^`DS;V9W^`Db]1mW^`RHnFN_^`bV[6>S^`d`e>]?^`l4HR=O^a2]C9io^a7KZ>5c^"
    "a8SEF6c^a<2jJAG^a?S0BFg^aHa21nG^aUO9]^3^aZDc9=_^a[neJNW^a^lg:A_^aoTLFYC^"
    "b6@mj5g^b:TmgKK^bH86iYo^c81@b7;^cFmJV5W^cKSd:9W^cNBCBRS^d9ei>EO^dAGF^33^"
    "dHG1ZFg^dWYgB:O^dedCnMW^e166VAW^e8HMbMS^e8In=Y7^e=d>>2O^e>F[VB_^e?@SAjC^"
    "eJREij3^eK4c=nC^eUoN:Z[^eWM8EaC^eYnbC6g^eZcOB9W^ebWmN2O^f54KVRc^fPpRBR[^"
    "fQLgFFc^fcknFe?^fd^QZ9W^gBb1:6G^gDl;BMO^gQ;36F_^gWW0B9g^gp>@NIK^ghlH5bO^"
    "h5ZOa^3^hA<O:e3^hA@Tn>S^hH4TYj7^hNg=ZIG^hZSZfRg^hc]UZA_^heGD2AS^hgNKV>O^"
    "hhCLmZ;^i1@^ZEc^i@^1f:[^iJpmn1_^iML9Mnc^iX?bZA[^ig6Uj?C^inMYFN_^jja^^A?^"
    "k7e=FNc^kPhV62C^kQALZES^k]oTB:W^kcGpAjo^kgF=JJ_^l4=Jn0k^l4@0F6W^l::8FR_^"
    "l:neF=W^lFh?n5S^lLI5anO^lU?aZJW^lV@:j;?^l`DOAe[^m0ghF^o^m=][]b;^mDigZ=S^"
    "mW9k1bC^mbmG=nC^me7QFEW^n7bFF9g^n>S`Ye[^nGg<BQW^nI7^9Z;^nPSNbi7^nUeeeYk^"
    "nYpWQnO^n]V52FW^no2S^AK^o=7QF6S^oERZ6=S^oFUgR9G^oHNc1V3^oI^3VR_^oJcVQbG^"
    "oTCe2^_^oVS`ZIW^oaECZ>_^ob=n>E_^ocAhEjK^og?KZB[^0O;B?3;^0[iIji3^0n;g2M?^"
    "1GX6E^?^1h>7g37^1mbMBFc^24l?Nm3^26FnbAO^2:PTn6[^2AZG:Po^2Oc>5jG^2i?MJIO^"
    "3FeBj^_^3Mo56pk^3SSJVNg^3`AR>9S^3gKDIMk^3kTjVlg^49]aQec^4E19i>C^4ZCc2W3^"
    "53`2FXo^5@N:1ZK^5F2OMic^5M<AYN3^5l<fNB_^63FXZ[C^6YPoY][^6f?7AbK^7Jn^o7?^"
    "7LINB>?^8?Alimg^90_p?3;^9=Mcjhk^9O`A2EC^9Vj3=5k]9e2j:=S^9i<PE^?^:1a1bN_^"
    ":IbQfZk^:OFgFB[^:VPYR];^:p4nn2S^:c>a:A7^;oSO6Lo^<3]5B^g^<57dVJ[^<Ael>9W^"
    "<Ho^IUk^<M9DVXo^<YgLAJK^<[B;Qec^<fUSiFK^=4^Jf6O^=;h=2Nk^=UDLJY7^=b2T1^O^"
    "=n`[]V7^>Tk2ZWC^>llR^lk^?;5IYaW^?GcQAnG^?X[?9eg^?lS8no;^@9A@ZK7^@mTNR6S^"
    "A:BV=f7^ARD6Bg;^A_2=j]3^B1D[2AK^B8NM=M_^BJ`jEfC^BkFkfN_^C0kAF>W^C853RIK^"
    "C=YHmnG^CDc;:=C^DQ7i6M3^DUAOFc3^DjT8M]g^Dn]^ZY7^E;KfAVO^EH9mmFG^E]LW6F_^"
    "EnDDk7C^F6hfJQC^FCVn1bO^FPE5]Z7^G6OLZS;^GNPl^lk^GpYcYaW^Ggm<0moXGiGkAnO^"
    "H662n5_^HN7S2_7^HZeZZ>o^J3hPB_7^J@VWjQ7^JRi52=O^JZ2g=Uc^J^<MJDo^KEaSZA_^"
    "KLkEfFO^KYYMRA_^KfGU>5O^LCmJ]Eo^M2pC:E;^M6eiFRc^ML8RMag^MPB8ZIC^M]0@A^G^"
    "Mi^GmN?^N?116BW^NOh^jc3^NXM@JIK^Ne;H1jO^O1iO]b7^OVY7JZg^P05F^Xo^PIQV1JC^"
    "Po[m2S3^Q<J4Z:g^QMAbR^g^QYoj:a?^R3L9MEg^RAU0J=g^RNC86FW^RULjB_7^Rb;1jI?^"
    "S;WAA]_^S?`gN=?^SnO_jBC^T;=gR=k^TGko>1[^TL5UJQ;^TeQd]Ug^UT@]:E?^UXJCFJc^"
    "UmplMig^V1fRZMG^V>TZAbC^VG9;b1W^VKBamV7^W1M8nVo^WdEWUf;^X8=QJJ[^XI5?Bc3^"
    "XQY`^Q;^XUcFj;3^Xk601VC^YJ6Tf6O^YQ@G2Jo^YVdpMf;^Y]nNZ6[^Ynf<R^o^Z;TD>U?^"
    "ZU0SQMk^[5VU377^[71DBVk^[C_KnAK^[O2dG0o^[];[Aac^[aEAN5K^[hO3Y23^piPI=mc^"
    "pmYoJMC^]4caTm[X]AQiA:K^]G6>]]o^]OZ`:??^]gp@>Zk^^9n]FBW^^SJlZIK^^`94EjG^"
    "^lg;m^7^_k32n]7^`RX9>1k^`YakJBS^`jYYBW3^a3>:bI?^a7G`n6k^aLZJ5^G^b2da2Fg^"
    "b?Rh^2O^bPJVRW3^b]8^>EG^be]?Y^g^c6TmQYg^cW:o33;^cXU^BNc^ceCen=S^d0W>Flk^"
    "d=EF1:C^d>`5Aec^dBi[N1S^dJ3MY9k^dX<DV6S^e0=d[;G^eO>IJIG^eVH;UE[^ec6CARS^"
    "ehZX]ag^fI@Z>F[^f[S7F>S^fbpiRIC^g4oFZAO^g<98eak^gA]NEjG^gNKUmb;^hLWM2U7^"
    "hf3pEJG^iL>3BJ_^iTbTbEG^iXl:n2_^in>d5fG^jTI;2F_^ja7B^2K^je@hjbk^jlJ[70k^"
    "k1o0RVo^k>]8>EK^kEfjI9k^kX9GQ]k^l8_I2g3^lR;XF`k^l^i`1NK^ldN5Mm[^lkWgYB3^"
    "mQb>ZgC^n0bcJES^nDZ]A^K^nc[B21c^nje4>FK^o]]Rieg^00002:7^0;jUV23^0m6a>Mk^"
    "1@Y1V=o^1eN6NAg^2=F=ER3^2C9:V:G^2OO7Af7^2[Ipeio^2i?MIN3Y35mU1Mo]36786>?^"
    "39M<Ej;^3>gnU^;^3B[p]Qk^3IYHN>3^3JbT=^7^3OIdIU_^3p7l1Uo^3hf3]f;^3i0o^Io^"
    "4Fp3f2?^4c><V>3^4f7`jJ3^59Z1BEk^5M<AZR3^5XlCUik^5`@h25k^5jA[M^7^60b]aMk^"
    "6<JUIj3^6=PeI][^6HE:mio^6J>m623^6ZN4ij7^6ddH1b?^6fHZN63^6kcL]ZC^77^2Eek^"
    "7BZH:=o^7DL9nB7^7ag3IfG^7b1oJMo^7l[HnJ;^88KJimk^8^i^ajC^92[12V3^99m<9nK^"
    "9Ega]]k^9F=AJN3^9ckA>27^:1a1aEWX:>O9MF?[:@JNB>;^:GIS1Z7^:K=A9J;^:SD8Ub;^"
    ":WkHaQ_^:dYPMYo^;1GX5f;^;O=XB:7^;[2o:Ug^;nU?R5o^<hbLJ5k^<kp0^Z?^=2c?e]o^"
    "=9DB9Mk]=?>A6R3^=Dl9ab7^=F2IeUk^=Pf_Img^=R`QNN3^=boYAj;^=nj>in7^>4E19Z?^"
    ">@?V]^3^>H:I>>?^>Lm^In7^?H>WnEo^?T3nfIo^?gKC=fG^?gV?>9g^@BN`Uj;^@NIF9]o^"
    "@acL69g^@d]0JV?^@lLeYj7^A8?@fF3^A:BV=N3XA=b=QjC^AG0]eF?ZAKaQ>Io^AOk7Ib3^"
    "AS^eQNC^A[e]1jC^A`Lm=Qg^Am;4eYg^B9i<Qf;^BT]YBFG^C@;jn:7^CC1IN67^CKklj5c^"
    "CQQBebG^D;DdAm[^DAefUZ;^DMM^=j?^DNSn=V7^DYHCab7^Dj][Y^7^E1@@RB7^E5gPf27^"
    "E7KcAb;^E<fUQV?^EDbPjMo^EHa;9b;^GVjjQj7^Gm:O25g^H:I<Emo^HBd:UJ3VHFCaifC^"
    "HORBAN7^HXL[ej3^Hp@ImJ7^HdGAIf;^HhnQUMk^I5pYAYc^I=cPVAo^IBJ`ij3^IIXgNI_^"
    "IQE`n:3^I];7f9c^JZ2g=fG^Jmd9N:3^K7kc5f;^KCfHYYc^KJGJmV;^KUoBUn?^KW5RYZ3^"
    "Kaih=f;^L3?@1^3^L8Z2ARG^L>I5>23^L?mG]b;^LEH9m^;^LQB_Qb?^M6dPF23^MJF`^9k^"
    "MV<7VI_^Mi^GnJ3^N_LNmj3^Nfe9:Qk^O0afa^7^O:GIR9o^OBj`^67^OKE_1J7VONeFEf3^"
    "OX3fYJC[O`n@>B7^OdanER?^Olhef23^P1P61Mk^P>>=Yb7^PJlEFB3^PoeP25o^QCG`JEo^"
    "QHe>26;^Qb_GZEk^QnDMUR;^R@MGQn;^RLGm5]o^RRhoI]_^R_W71^7^R_f8jF;^RjKLUn7^"
    "S3HIBIg^S;`dM^3^SA;V]V?^SFjYZB3^SM6<AV3^SMi^EfC^SYdCmfC^TCmE223^UA00In;^"
    "UIjSej3^UOk0R:3^U[`GJIk^UoBWbEo^V9CK=b;^VKLE9j3^VSgCIFGTVWFj]n3^V`UK5Io["
    "ViOdYn7^VlIHnMo^VmCRaN3^W5JJ>67^W:1ZIUo^W?kYFIo^WF_b5^;^WSMi^:3^Wd`^>A[^"
    "X5EQ2>;^Y6f1m]o^YHl0>Io^YHnkif;^YTaG6Ik^YTiQMb3^Y[JSaY_^Yh8[Mf?^YhCWN=g^"
    "Z2m11j;^ZDBHeb3^ZEn[V:7^ZI];5RK^ZUW`]Uo^ZVKBaf?^ZbEhEb?^[8lY2N3^[LNiJV3^"
    "pFp6F>;^pIQTf67^pRL8Aig^]5jJ1^3^]AdoUao^]Aloj=o^]C^a^5o^]SmiQj;^]pHgeF7Y"
    "]_hO9mk^]aDW:Ik^]i6oMMo^^1=fmeo^^5e79R7^^=knYj7^^BS>eMk^^OAFM^;^^^GBV1c^"
    "_1k?Qio^_1mXbR;^_EOi:N3^`3WTMf7^`?GVIUk^`Fp:afC^`NL1>>?^`W>0QUS^`]K5j27^"
    "`cl8=Ug^`n`M]^3^a0Z?en7^a9jBn>;^aLcmAnC^aNP@2:7^aR>_QVG^aZEVjEk^a^9E5V7^"
    "a^lg9n?^ajgLab?^amggB1o^bjnXNR?^c>PhfJ3^cR39>>3^clC4QYk^d>KnMb7^dJFT1ao^"
    "dL@F:63^dX<DUF7VdpOMmj;^ddjL=F3XdhJ3Qb;^dmdea^G^e1XSiR7]e9_KIb3^e>F[UR3^"
    "eFMS1b7^eGQ?^Eo^eK4c=Qo^eWbjif?^efhfn5g^ekT=62?^g7QhVJ7^g<98en7^gCG?NIO^"
    "gGi:aZ;^gK48n=o^gViOf9_^g__TmY[^gelZAj;^glMpU]_^h7B29b;^h9;dAf3^hIJl5mo^"
    "hUEQYf;^hZ`CiVG^hfZiQ]k^hgNKV:3^hgRQJB3^i3I19j7^jEKaV5g^k0RhBB7^k4dXi][^"
    "kD58ZEo^kFmRej7^kOjORI_^kRh8Ib7^k`]hmF;TkcL_j9k^kmL0YIkZl0kWmj;^l6FJ=^?^"
    "l::8EMo^lB@oab7^lFh?mMk^lSVGYMk^l`DOAb;^l`OKAik^l`SQ:J3^ldjhemo^m45aR9o^"
    "nDZ]B63^nPJ_=j3^nhA9EYW^niSgn5o^o3i0mmo^o4oA1Yc^o=68FJ3^o?cVUb3^oA]HYio^"
    "oPXH^:7^oQlPN23^opM_VEg^o]g65j3^ocAhEVG^oo<Miec^00001fG^05^ZJUK^08:inZ_^"
    "0A3AMbW^0NVO>IO^0RBhNQO^13c?nNW^17TDEQc]19@EBFS^1?CSIZ3^1@Y1V1k^1pJ9eUo^"
    "1]:@f];^1ac9EB[^1bCIbY3^1bPXj6;^1c;J>RW^26VP:]C^2=DXZa7^2HUJ^UO^2SjBNR_^"
    "2V<MNQO^2^;VMY_^2aZ1ZY?^2k9BZV[^3AG;9Qk^3B[p^6G^3J]bZZg^3LAEjNW^3_m35Uc^"
    "406=fYC^40Dkaa[^47M5RYC^4Ba<fEG^4K:TVN[^4UlmUlg^4V6DMUg^4po5bJS^4]bK^a;^"
    "4`7YjQS^4a^OYJ;]4fhaAn;^4hRgYZ?^4jJU6:S^56Z@RQO^5:R^jg7^5@B1^QK^5@^]]V;^"
    "5M<AYmo^5O3jIB3^5UZ;R9_^5e_IRRW^5fUo:E[^5gGD]a[^5o3i1f?^61OFAI_^677aVEO^"
    "6@?9QV3^6F54>QC^6JG;6AK^6X^OaN3Y6c>ojIG^76T7R9G^7@pNJVW^7HHBFRW^7bQi>NS^"
    "7bUWbIO^816T:6C^8Aai^BW^8B2GbC;^8WUTZMO^8Y]7IEg^8jdn:AO^9CpbnAO^9Ef=6a?^"
    "9EfU]nS^9UpCRMK^9]LHfMC^9^FXj^c^9j;V2]?^9kCTjbg^:05dMR3^:0UDBJW^:3Zg6V[^"
    ":7Uf^IO^:A=WfUO^:LNIjAO^:TbjFJ[^:__VnRW^:hBje]g^:k5Q=fS^;83G^IO^;8Wb>YC^"
    ";9RR6RW^;9i=jRW^;>oWJFW^;F@Y^Zc^;JbPe>W^;KBa>MG^;Sp92NW^;Y9>FJW^;d:V2=O^"
    ";hY>BUO^<14L1ZK^<HcV6]?^<ko7abG^<n@mnZ[^=5laf>W^=7QGUmg^=?oAJ9g^=GM95V3^"
    "=Rh_RAS^=pMdZVk^=kV`Ii[^=k`TFQK^=l:>nJS^=n`[]mk^>76kVR[^>7>UR:S^>=;ZEa[^"
    ">?8=aIcX>?pOFEg^>H:I=n7^>IianMO^>Pif^R[^>VFl6J_^>p`emR;^>gc=J>W^>i^5=Z?^"
    ">k3MZRW^?0PS2JS^?HWM9Mcp?JCN6:S^?^RBU]W^?`792MS^?`[=6RW^?b>[aR3^?i>Q1Z7^"
    "?n=IZ]C^?nZYeZW^@3FRVEO^@:@;en7^@=iDN^c^@J=4F6S^@L>GJIK^@[8gn7;^@^dM]Uc^"
    "@_SO29S^@`C_9U_^@g71ZB[^A1GYbNW^A;V]f4c^A<<KN^_^ANN@>NW^ATonB]?^A]NE>=[^"
    "AhA;FN[^Am^@^JW^B@Tl6MO^BA9FZ];^BB46Nbg^BBJbBNW^BGQ;fJ[^BSdEZMO^BTUoBFW^"
    "BaD6nF_^BaZbbFW^Be?KZ5?^Blp:NEO^Bm0pnNW^C1:b^QO^C9V0MRS^C@1B69S^CF7BfFS^"
    "CQE:RYC^CU@Y6VW^C^S]V:W^CeHbfRW^Cgnj:>[^Cj<oFUS^D6;bE]c^D6bRF^c^D>NFBFW^"
    "DH:jJES^DIS3F5O^DXAAJ:W^DXWm>FO^Da2_>IO^DbhUFNS^E3ahEBG^E4B8^MO^E4[cJRW^"
    "E?XP2V[^EC9ZNQS^EH9mnF7^EM9mRAO^EQ_W>VW^EVa^^AO^EYKK:V_^EYb6jJS^E^hPNN[^"
    "EaS[N>S^F3U22NW^F3f^YV?^F8[KV_7^F927JFW^FPE5^2C^FRe2R6O^FXboRB3^FZAaJRW^"
    "Fa@iEn?^FhX]NMO^Fj0fJ9O^G:ZVf9k^GAPRBIS^GFJhjbc^GT_kbIS^GViEj]C^GbjNJ^c^"
    "Gh53NAO^GoXV2J[^H0EU>]?^H4R:>6O^H:hBIJ;^H;cFm`o^HcCTN>W^I0b_b^_^I4?H:7G^"
    "I:[n9bS^IE;;f6[^II6PRIO^IJNYNAO^IJUZjg3^IJlF^RW^IP2`>Nc^IR=hM^?^IpEj2IS^"
    "I];7en3^Iie[FF[^Ij<G:>S^Ik=KbUO^Ima05Q[^J5=^f=W^J9pG6UG^J>eP2Y7^J?2_=nC^"
    "JS8VJUO^JYf^jUG^J[F5MIo^J]b=RZ[^JeF?VF7^JmjG>RW^K7kdNRS^K>]FaV;^KG=fn@W^"
    "K]7R5^?^K_=bn6_^KjlLR5W^KlmV]YG^L<c]:MO^L==GbV_^LLXD6QK^LLg21][^L^hn]YW^"
    "L_CC6IK^LbC[FRW^Lbl3]N7^LgJ4jR[^Li0YV=[^LofdV>K^M;chQJ3^MAS[fF[^MQ^KjB[^"
    "MW4e:fg^MYeUAZ;^MYnIN6g^MZok:2W^M`ZKAUo^MkV0]JG^N1:AfUG^N2<Ab5g^N2RJbAK^"
    "N4bfAJC^NJ26ZIS^NKJ?V5W^NKUoAfG^NNlMBZ[^NQB_6VW^NV4[IV7^Npa?aJG^O1iO^9c^"
    "O69E2EO^O8::NFS^O:GIQj?^O?a6:MK^OCIfaV;^Op?0j5k^PS0=fEO^PS7?Bfo^PSMk6NS^"
    "PXTDZJ[^PX]aBAO^PXk0NFW^PdWVNRW^Q2G?bB[^Q2]kUnO^Q3_0>UK^Q6BTMQW^Q<J4Z2W^"
    "Q=l5JYG^QMEhG33^QO:IB5S^Q^Ap2BO^QbHCFQK^QcgYiZ;^R2>Ib=O^RAOS2Fc^RGe[:V[^"
    "RXg0nRW^S3N0nAS^S:`SnMS^S;=?m^;^SEEARQO^SU9hNUO^S^IhNQO^Sbb`2VW^SgdgRMK^"
    "SjNSnZg^Sje?^NS^SkMX9]_^SokYBRW^T1@:b=W^TDELmV;^TH]2bBW^TI^TJF[^TJ5@>FS^"
    "T]S^>QK^TbOmiVW^U;3o>A[^U<:36A7^U=DJYNC^U@aRZ5O^UO4YjMS^USkd29S^U[>G2QO^"
    "UfO96MO^V3EgBJ_^V7>:Z=O^V@[^fZ_^VHBZVQK^VKBamj;^VKkK=Yg^VS`[b:S^Vp>UZ9c^"
    "VdpOMjC^Vdc@1Qo[W2Sm:MK^W?i7YnW^WSMi]^;^WU[FBbk^W[QbBES^W[Xc^bk^W[paU^3^"
    "W[oORV[^Wa5i2JW^WaLTfNW^WlgW>=g^X:=nF6S^X;?On6S^X;p:6QO^X<@TVMO^XEXX=ZO^"
    "XE`WANC^XFMYbUG^XFll:MS^XJ_OjUK^XSQG^E;^XVbB6:G^XW[m^AS^X]N>=Yc^Xf_:Un_^"
    "Xh`MZIO^XlI>AV?^Y5mTMQkWYEA35M[^YW]=f:K^Y_?ZeU[^YePEYe;^YfLHRGG^Z699Ffo^"
    "Z7H<:NW^ZNW<JZ_^Zp9m:QS^Z][LjYG^Z^V<bZ[^Za17IEg^ZfkLfQS^ZgJ_>MS^[3Fd:RS^"
    "[89`b=S^[8M=^NW^[AaQn5G^[Lg1EYo^[RVdZBS^[k1RAVK^p9JgEl_^pCUSVQK^pJFZmmo^"
    "pc_kN]?^pd<WMZ?^]GI?nQS^]I=CB^c^]Pd>nQO^]TLoUQo^^J^8bNS^^U=Qjc;^^d:H6^g^"
    "^dQ3jRW^^in9BNW^_=boYf?^_D=^RUK^_No>>QO^_ONPRYK^_W<]:4S^_i8NV>[^_jXbnBW^"
    "`3KL:QK^`4jb]a[^`?LTZZ[^`Ga<:bo^`Lg[NQO^`WJHYJC^`WjY5E_^a?eZb2O^aJ>]>IO^"
    "aW8`b^g^aa]B6>K^ad[QVUK^ag0_^=S^ag7a:fg^an_naRG^aoM1BUO^aolCZIS^b?Rh^CG^"
    "bAEMjRW^bJC6EUW^bUHUaYk^b[8I2BS^bn@JUMg^c7h;]Nc^c@pUEjS^cB07VBW^cL782]G^"
    "cNGSMNC^cQ@@n9K^cc_m>4[^clAOfe7^cnPDB]C^dE9DZMS^dPJ6^MO^dQ^gZ^c^dp3M]]c^"
    "dcM;:9_^e?N:1JO^eFWl>9c^eLHjf>S^eO4Z61k^eXEneBC^eXf?=eS^e]djEMk^e^5b6JW^"
    "e_`cFQC^ecihUEW^em2XFRW^f4>PV=;^f6POb:g^f=pc]JK^fKA7:F_^fKklnJW^fLBXb>S^"
    "fL_BjYG^fM;ni^C^f_VFmUc^feW7^MS^fiOV6FW^g=LG5a_^gNKUn=k^gP0XfNW^gTl2n5S^"
    "gVD;iZ3^g`L=MM[^gaGcQMg^h8a7:23^h9D2B9K^h_4WVA_^h_ZE>fk^hm=5nUK^hoRD:EO^"
    "hoYEV^c^i0E4bIS^i8Mh2a;^i;A==MW^i@l>jES^iRdZaY_^iS9^EMW]iU48EMk^iXl:n2W^"
    "i]j:9]_^ieH`F5K^ikA[RNW^ing3MAc^j0`SZRg^j:cbBF[^jLC76>[^jTXpJa?^jYaeF9K^"
    "jZYefNS^jiU<RJW^k4c4Ba7^k@3fBQO^kKLcjBS^kMZi6QK^kW_F=N;]kXk[6MS^kZ@L6fk^"
    "l>Gm=ac^lB<>>^g^lRXQeQ_^lW?b1R3^lkWgZ5_^m45aR5c^m54p]n?^m5=PjZc^m:?XJAO^"
    "m?249VO^mBY0>RS^mE1U::G^mMOO2=g^mSKo^NW^mU9^b5[^mU@gFUK^m`1C=Ek^mai0ZBS^"
    "mn8p:QO^n21:NJW^nKd5VNW^n]=e:R[^nnV=:IO^o68LZ2O^oAEFA:;[oAeV^AO^oV8]6MC^"
    "oX03n6S^oYSRjV[^oZ]KR=S^oiofQY_^000022;^05pWQMk^0EG7Z9[^0FJ;AEW]0pRVN6S^"
    "0pm2BQG^0^=lER;^0cjhV:O^16IAVQO^16iXZ:?^1@3V9:G^1CdC:RW^1F_A5RW^1TFZUF;^"
    "1lWjJZ[^1nn0fMS^2;p8QY_^2M3oJNS^2O2PNRS^2bT9ImW^36C6jJW^3G4K>AS^3QVQbRS^"
    "3TlkJBS^3ZfCZ=K^3_RENMS^3n^5:>S^4BF;^JS^4G2cF=c^4H3Z>QS^4PMen9S^4SDImF7["
    "4_d3fI_^4iLe66S^50TnnMS^58UDB6C^5>16RA[^5OK[>IO^5Q`K=6[^5VbFmj3^5X_fNV_^"
    "5Y6C^QS^62<5bRW^68W?jJS^6:A_mJC^6AWXRUO^6bc4]6C^6nf@RVW^7F>enIK^7KDIMRO^"
    "7RB9EM_^7RZB2MS^7^`Ij=;^7eNV^UG^7hJTN6S^83e^A>C^8<mLV5W^8UP]JNW^8U^]5j3^"
    "8pG31Bc^8`>XUQg^8aO_N2S^8jaMVIO^8nOmU^K^9:@on>c^9DhGaZW^9UUSbRW^9XN2Z:;^"
    "9XkmJNO^9mIpQJW^:30DNVW^:Q?h]Ig^:TjPnk3^:hKobUK^;>9XNBW^;_<H1Ig^;_[5F9S^"
    "<9=F62g^<H<J61S^<WipfNS^<Wm?ZIS^<Yh=jRW^<`mZQJ;Z<aAJfR[^<ibMYAop=0;Y>2G^"
    "=@NTJIO^=AHMf1W^=INoEMo]=Z9^B2K^>20D5IgZ>@RZbRW^>LRW:MS^>ZQXeN3]>^:7IF3Z"
    ">n0;6US^?4BRR2O^?53kjQO^?AYSUAo^?C2mUYo^?GLJJQO^?d>cjRW^?kTBEMo^@3C22UG^"
    "@CLmFNW^@L_AF5S^@T5W5Qo^A1gDj6[^A<VkiZS^A[eIn>_^A]7faJ3^AaA<:5_^Am>mQ^K^"
    "B3@Aj6W^B9m5>NS^B:2LZ6?^BDj;BNW^BF[<fNc^BRc]9nK^BXKd=mW^Bk4F1Io^CP]nN=S^"
    "CUJ0BMS^C`KA>RW^CcaZfRS^CiboBRW^CkTX:RW^D=kE2IS^DB0OVQ;^DC?>VR[^DD1R1m_^"
    "DFEPb9S^Dp5V9E_]D`=RB=O^DfLYbMS^E3S0R:W^EECF2IO^EGX619c^ENmnRMS^EQ`3=nG^"
    "Eblgf1c^Ede161O^Ej25MF7]EmdZbEO^F09JaJg^F7OCFIS^F;^8F:?^FTOHb6S^FXZ_Q:?^"
    "F`0X6QO^Fb_JBNS^Ff6e6QO^G;dVJQK^G?eYFMW^GA<4A:S^GU@e^EO^Gi]I5>S^Gol8ZRW^"
    "HR>]eF_^H`Y8IU[^HhodeIg^Hof2fQO^I5`QmV;^I:`2UVW^I?8?n6S^IO<aBN[^IQ<S5e[^"
    "ISK^j>O^IVVURRW^IcAGEBo^IdXSN5K^JBeV>=o^JJlA:VW^JNBZbFW^JV;4NFO^J[VfZ5c^"
    "K4H79j7^KUR`:5S^KgmT=F3]L>44j5S^L>5oF6S^LVeEEEoXLcTiV9?^M5j3MJ7]M6F?>QO^"
    "M<F:6U?^M?3CjQO^M?FZ9J;[MXOS>QO^MZS<b5c^MZn62VW^M^gSnAO^MfD?:O?^MggniQk^"
    "MnWHBNO^N3DMAb;^N=9_M=g^N?5OZ>o^NDF:fQK^NDQAf9[^NHG=bUK^NN:4V1W^NPICYN7p"
    "NQ9pRNS^NQFgMF7]NWf`62?^N]BRF2?^NfkCUAo[NjkV^QO^O63bb:;^O8jXIMo^OAXRjVW^"
    "OaKm9R;^Oi:pe]W^P4gbeEk]P6;IMEkYP>B6EZK^PImAiMo^PW^EZN_^PmU7^NS^Q2NV]N;]"
    "R4b>>JS^R:f86V[^RF<mR9c^RGT?^Vc^RTBGJNW^S3eRAJ3^SF03JRW^SKA[6MS^So6n65K^"
    "T3bofMS^TTBonUG^TUanVRW^TY8H>FS^TpDDV9S^TlZPBRW^U;;0fMO^U=O`eJC^UDeYFQS^"
    "ULg_>IS^UcpEVIO^Uf15U>_^UfCnRMO^UmFn6ES^V2cAYEkZVGhY9l_^VHkpb6W^VNRJEQO^"
    "VQOE1n;^VUhBjIS^W73_567YW9K:6:O^W>flF63^W@_`iB3pWSMi]j3^WWX<b2?^W^;YiJG^"
    "W_U3iF3^W`?j6JS^X9M5^JO^XH6HY>?^XOe8BMK^X[oInRW^XcQOeF7WY0W]INS^Y120bRW^"
    "Y1a11AoZY=CbVV_^YP5d:Zg^YY929>7^Y_V?bEO^Z8GP>Fg^Z=cBN1c^Z?]PAEg]ZWpMZRW^"
    "Zc=C:R_^ZoEcInK^[54KNRS^[8Je:NS^[?`9AM[^[@RWn5o^[CHE6UK^[YChN>?^[pdTJYG^"
    "p3k_^5S^ppM4N5S^p`SXE][^pl=j2QO^]5>DmN;]]>[?]F3^]T_>bIO^]]_Y]Uc^]aeLBMO^"
    "^>iMUnW^^F@nMR7]^`Wp2NW^^`cARMO^^cn5ZFS^^haNNJW^^nbC=Mo]_11O66[^_B>CZ=[^"
    "_IDVBMS^_WCWmN3^_ZoT9nO^_`KFF9c^`6LDZ6C^`9<Vf1g^`=Xo5AkY`?dl]N3^`B^K2VW^"
    "`QmgAV7^`SaJ>6S^`XWHRV_^`gN>UMg^`hFAQRC^aKUNEAkXaPgVAJ7XbA:Yb=;^bDBc:JO^"
    "bKiiNU?^b_GpN5[^beF8bUG^bfe7JJS^c2]:^>W^c88lmmk^c<V^ME_^cA9EjAS^cCioF6o^"
    "cPj=IbC^cp[?b:g^c]jh2MO^cb7229_^cdnXf9O^ciZZZMS^cjXo]Y[^d7G7FIS^d:hBN:C^"
    "dJS=]M[^dR;oJ=S^dSYRn6O^e12[ZIS^e3GKYO7^e:]D:QS^eC@RVJS^eYT0JEO^e[h`I>[^"
    "ec>XjQS^em`HJVW^f1C2jFW^f;TMeJ7^fDJ59^[^fK_m^IS^fY2U]Eo^f`hA6MS^fa3H61_^"
    "fjp:ei[^flkIi>CZfmhm]:K^g4HfIf[^g8nU^RS^gGp]ZV[^gIPm9F3pgRUi6:?^gUL^]R?^"
    "gpbW>QO^ga8lnV_^gcb]Z5c^h=n3MBS^hB>AnJO^hR]O]2G^hUE>VBO^hfOH=Fc^hkMINJW^"
    "hncc6>S^i4@KnRW^iO0pmR;^iTKMjUK^img]>QK^jHNpQF?]jQDDNNW^j^W7Z6S^jb_3b1G^"
    "jd6EnVW^jiO:Fa3^k3:T5Q_^k<:=b5o^kVK;aEW]kXbEbVW^kicJR5S^kmaRNNW^l>?Yb6?^"
    "lC[L2A[^lRD_B1S^lW0jB:S^l`HGn>S^lb5TfQO^lk5oaNG]m5=ln2?^mGLKiQC^mJViVIO^"
    "mSWDQN7^m]Tg26S^n<8YAZG^nP>B2R[^nUHk9QW^nVZlFQS^ndJ_N0o^ndYn1MopniZQFV_^"
    "o=;ojIK^o?<A6QS^oJ_fFNW^oM;BaZ?^oN6?nNS^oUm@JFW^01<BARC^04C_Uf?^06b;bV_^"
    "082cbES^0=jImZG^0=mOenO^0?;D1j?^0?H?6F[^0B^nnMG^0FgiIj3^0LYN:N[^0L^?^A[^"
    "0ZjVBJ_^0bACVAg^0cC^QYc^0d7fafC^0hVmN:W^0jf>a]W^0jfPfN[^0jkBJE_^0kADe^C^"
    "0l]429o^0le=Qmo^0oRRVAW^0oYSn]7^188UnEK^1>F6F6W^1AnK>5W^1D3C=]c^1Dh[FF_^"
    "1E`Jnno^1GXd>J[^1I3SRVc^1VhMmYo^1Z2_5b3^1`;Mj5[^1bPXif7^1c5^1f7^1d<Pf6K^"
    "1e9<FBc^1eefjjk^1jnRafC^1k`RnEk^1o^P2o3^22JKJ>c^25jV^=O^27_<>2o^287XAfG^"
    "299kREW^2;jFIbG^2>HPVE[^2?lG9RK^2@UR5Yk^2@Van=O^2CF?2FK^2DH@A^?^2Go:mE_R"
    "2H2@f53^2Ihd6JW^2JV2^E[^2K[oJ^o^2L0=jV[^2Lf:5bK^2PWN6BO^2V_a20o^2W:36Fc^"
    "2[44Yn?^2pH<AUk^2]iS=e7^2f:Qj>G^2f?gUV3P2jWZfJc^2n]aIQc^35G5b>W^39H8^>W^"
    "3;OH^EK^3>cXiRK^3CJi5jS^3CX=jZ_^3C`GN:C^3DhenMG^3EPW>:C^3FkFNBW^3H>>BVc^"
    "3HdKQi_^3KWHB=S^3Khbj>W^3LO09i[^3P90]^K^3Pb1f5[^3Q1VNBG^3Q?cR1[^3^jhb=[^"
    "3_RO]jO^3c]Yj:O^3e8I:ZG^3fI1:=g^3fnlJ1S^3kY0JF[^3mVBnZg^3nfk2IO^3oCJ]iO^"
    "41a;:N[^42BDbIO^43jZj=_^47aDUiK^48G861k^49[?^AO^4:o[R:K^4;4M6=o^4<HTbQ?^"
    "4@K;]a_^4CZPNAW^4FFSR9c^4JP_j:K^4TDWIU[^4Vm:j:S^4YAOb=o^4a_IZI_^4cI1b]G^"
    "4fFYf9o^4npJ:]C^50[6j2S^52[i6bg^5?gZ^NW^5AfGN1[^5B`Xj=?^5H`HUJ;^5J3nB]C^"
    "5LiLfQG^5NQ[B9W^5O?UYjk^5QKkJFS^5S3Cb2S^5pYn:V_^5]MP>N_^5^4]JVW^5bA[R4_^"
    "5b`_>IK^5cP=VYO^5l^]nAO^5o3i1f3P61R39mS^65<Wf9O^65Y7RIK^67Qbe^7^68Cc2Ic^"
    "69=ZanW^6BdE:FW^6EP@N>c^6E]UEnW^6FLYn:7^6GKUFBW^6Jk`ZAW^6VL4:Fc^6XGHn:W^"
    "6XMJJIS^6ZNbbN[^6_:dV]C^6_W<VMK^6c]C::?^6h5b>2O^6i8cFEK^70Sp2:[^75`;YnC^"
    "76TKZJ[^7:?0FFW^7=GgBUC^7=d?BIO^7Eea6]3^7L<e=Ug^7Mh]6:W^7P>ei6C]7R3gBFG^"
    "7TZ_1Uk^7UE9amc^7WZ^VFg^7XL32BO^7Y2@Aeg^7ZQa6BO^7[lPJB[^7]8XeUk^7]c3Z5g^"
    "7_E6AjO^7_kCRBW^7`XR:AO^7ec;b=W^7n8l6=[^816T9f;^83l2^Ac^83l:ImS^89TMn1g^"
    "8:9S6FO^8;J;69_^8=RdaN;[8>eTfEK^8?0@=Yk^8BR[EfC^8BdH2IO^8DN0:5S^8EOMAb?^"
    "8N4ZQN3^8Nc1B33^8P5W2Eg^8X[ZJIS^8Y_O2UC^8]j?MmS^8`_^1j?^8`lY6BW^8gPieUS^"
    "8n=h:N[^8nBY^AS^91c[=Ak^9A0?21o^9A]MZBW^9C]T6aC^9Ce]VEg^9DGe1^?^9Ep@ejG^"
    "9H^ZN6K^9J;GN6O^9LJjfN[^9LOpJEC^9Le^ebC^9Q6lVAc^9YponEK^9ZLNEig^9p_QB>O^"
    "9]9cJMC^9_jPF:K^9cRe>9O^:0SEEfK^:;W95f;^:=C122W^:A_gj5_^:D52mf;^:F]VJB_^"
    ":R@eJ>c^:U0fUf?^:WO0bAK^:Y2gEN[^:YCV>;7^:ZQJJJS^:Z^ER=S^:]N`MbK^:dbORZg^"
    ":djY6>K^:elZA^C^:iVZf4o^:l:L^EW^;1PW>JW^;2;h6BS^;5NpN5[^;8D;24c^;8^M66O^"
    ";?FGaV3P;?Mm=lg^;FWg6AK^;G^kn6;^;GdAUUc^;L<4jJc^;P>QMI[Y;THmb6G^;VkOb6[^"
    ";ZlR^:W^;[p19McZ;]3b^AG^;eDaN>O^;hO`NBW^;mU`9Z3^;oRk22C^<2FKf1k^<2d=R1_^"
    "<58@MI_p<>KdNA_^<@OBbAW^<A6i]nS^<C:62=c^<EB3j6G^<HSFImS^<NUWiek^<O:]2RO^"
    "<P[_b>3^<Sf^bMO^<WSe=eg^<Y@lnbg^<a:OUV3^<e>jNAO^<f`I6U?^<l59j6G^<mK7UJ3p"
    "=4JjB>_^=5`gib3^=8QTj>K^=:0Q^>c^=B;^iZK^=C?22Vg^=CCcZEg^=V^WVJ[^=XfgR=k^"
    "=YHnin3P=ZUA>6[^=]_dJ6[^=_<QJ:[^=aL4bVO^=afhaIo^=d;kUV?^=gCHiZC^=hF5eZW^"
    "=hc;aVS^=kjY5jC^>0m9:FO^>1`[>6O^>30ENB[^>5QCMV?^>>Nbj5_^>?Y7NN[^>Cf5R0[^"
    ">DE9>IS^>H:I=b3P>PXC1f3^>RD:ibS^>W7P6:S^>Yh=6Ek^>[^`B2[^>_p]FUC^>bR;jUG^"
    ">ceWaZC^>lP:Z9S^>nD`::g^>oRBAm[^?4n4R9W^?7hDZZc^?80N:BW^?98lZIO^?9kbnB[^"
    "?:1dJAG^?<MW6:S^?@ALj1S^?A;VVES^?EA]>2O^?G=22NG^?Ih7ANG[?KAfUaO^?KiWe]o^"
    "?QYXV2?^?TO79]G^?WDU^2?^?X8eZF[^?a=>bBc^?eCEEY_^?hj@2]?^?iEF5>;^?ma?=j?^"
    "?oM76>W^@3VKBQC^@6?91Yk^@6EhFJ[^@6l5Umk^@:VZAmg^@=PjJJ[^@B<l:=S^@CW7Jbg^"
    "@D=DZ1[^@GGUb9g^@M2ZV=O^@O]F69[^@RZn9j;^@UPL^AG^@X6`EMo^@Y5IZ1k^@[]m6FO^"
    "@]TPFEC^@`InfMC^@dHb2IK^A0GKB;;^A1U?NF[^A1Z12=c^A6JRIZK]A70_ZAK^A7hOBUK^"
    "A:@4JES^A;d4eaW^ABQ3:JO^AMR^f6[^AObB:F[^AOg3^=k^ASH5=Ic^ATNCjB3^AV]C>jk^"
    "AX?in9O^AYHZNaO^A[9::9W^A]NE=^C^A`UlBfo^Aae:Z2C^AafTFa;^AeJ7V=g^AfjD>YO^"
    "Ag@ZenK^Aj`mimK^Ak_aR>G^AlTUVBK^AmoDfNW^An46J5G^AoH>6YC^B2[FV=_^B;AIn=K^"
    "B<gZ:Z[^B>CkFBW^BBom697^BDfPFV_^BE7?>5O^BLA96N?^BPhIBEW^BT_2n9K^BYFC:Y?^"
    "BZfH69[^B]mSF=C^BcDAj=c^Bf>R1n3^BgEDf:O^BhB0JB[^Bn7Faf;^C29GQJc^C5`B>QG^"
    "C6U@UfC^C7W7MYk^C:h0B?7^C?3:MbG^CF2m6B[^CFO36>G^CFfO:>c^CGLpIeW^CK;4elo^"
    "CK_^61S^CM1X6N[^CM^f^=O^COYWNV[^CPM9R^c^CQ3FaYg^CS`B6>G^CXLgmb3PCYhU20c^"
    "CZBg62W^C_^GBMC^C`jaaQk^Ca2G=lg^Cl=D5nS^Cm@12A7^Cm`NjFc^Co8pEb;^D0dTB:[^"
    "D3DdEmg^D5mGb>C^D8Oib6W^D:K>VZ[^D;1Kei_^D<Pl^6G^DENL:2?^DFi;N6;^DKj]^5K^"
    "DO1VnBS^DQ7E26?^DRVejQC^DSjef5[^DTHWR1_^DVplN:[^DW>66MG^DY4YEjO^D[5KRbg^"
    "D`0>NB3^Db[C^2O^DcSEFbg^Dgp85ek^Dj7`ImW^DkXc9jG^E0_72V[^E5K8bMK^E@hFIbC^"
    "ECSo]mW^EE3PV^c^EFQWaQ_^EFcDN=O^EHDc6Y?^ELK_amg^EMQJJVk^EMYSn:G^ENDlRJc^"
    "EWEAmf7^EWR=2FO^EZ5nj>S^E_kEAF3PEdcL6NS^Edh=ZMo^EhI?9B;^F0:D69C^F2OO5n3P"
    "F3[aJBW^F3cjj2K^F6fDV>S^F8C1VBW^F9`nMUW[F:mHmQg^F=6Fan[^F?@8VJ_^F?D>J:G^"
    "F@Ii26W^FC0NbRW^FDo;QmW^FGpPRMO^FHT8N5g^FPBSjEO^FPihb1O^FTT_NB[^FZ8I:9O^"
    "Fa@iEj3PFc_3Q][^FeJORRS^FeiS>IW^Fi^c=mo^FjPcJIg^G2ab:FW^G3ohFAS^G;LW6Ac^"
    "G=C:F>W^G?JT:jo^GD6UjQO^GHXbMeK^GHY4RBO^GML7Z1S^GN4T^9O^GNNJj9k^GPEGeac^"
    "GR3Gemk^GT4DEfG^GUOMJ>[^GYGm69S^G[P=2B[^G[V>NAG^GpR>=b7^G]mG>:O^G^2166K^"
    "Gb`0ZIS^GcRnY^S^Ge081ek^Gff7>2S^GhaL2FG^GlAWJMO^H8ho]nK^H9]?^:[^H>IeQ]c^"
    "H@m3FEO^HBKfAEk^HBaXbBk^HE@N^6S^HFg_I]o^HFnN^NG^HI4<f>O^HMQ3^Fc^HM^HV6S^"
    "HNO]1J;VHOEY=Z3^HQR6Y^C^HXPOZ1g^HZOV667^H_5DJB[^HcaF>=K^He;QJbg^HeWiJ6S^"
    "Hhkob9[^Hn5cAnW^Ho>Sb6[^I1=@QQ_^I1A`69_^I74f^=K^I7pMY^O^I=BG6BS^I>Ro69W^"
    "I?8jF=S^I@Ym5f7^IAnHjMK^ICbnFF[^IE[OEfK^IPQ6227^IQkeB;;^IS9YNB[^IS>K69_^"
    "I[dNJEO^IaJaVBW^IbZ]f2G^Id5M:JS^Io78f:[^J1Fp:JW^J1KMb=o^J69_FQG^J6TeE^;^"
    "J8A]>fg^J?2_=bC^JFnQVAk^JHe4ejG^JJSNQUg^JL@VBno^JMD;R:S^JN8oVBS^JOS^fNO^"
    "JY`2JUO^Jpecn=O^J]7XIN?^J_hEF>K^JdTG657^Jf[Y>5[^JiUiJNW^JlF2BVc^K6>[Ffk^"
    "K:j]:QO^K<Jb6=[^KDh[j=_^KG5]Mak^KG=fmf;^KHi^f6O^KIfJJFW^KK?g]RW^KO[`aj?^"
    "KR<:^Jc^KW7YJ6S^KX9ZYb?^K[be5N7^KpLJB;C^K_9MAbO^KcOTeec^Kd`DRRg^KeFQamO^"
    "Kh3M6>G^KnV26BW^KoC@^=S^L1SH9j3PL:1AmV?^L;Lo2<[^L;gA6>[^LABaBAO^LBVa=lg^"
    "LECd=ZS^LH;6^N[^LH?<QfC^LI5pB9O^LJ8IBV_^LKI1BMG^LMPCJIG^LN^IVNc^LODhj>_^"
    "LR1ki^O^LRpFZQG^LSEYb2K^LVeA5B3^LZ4Cb:W^L[LQB>W^L`<V^=W^LbQkUiW^Lf2[1nS^"
    "Lg2f>2;^LjgmnR_^LkXTRJS^Ll8UnQK^LmO7^5O^M0V0nB_^M46NFNc^M5G6F9c^M5O?f1[^"
    "M5cV65[^M5m1Um_^M8AFR>_^M8bP6EO^M:Y3EjO^M>AOimK^MATXN>3^MKp:ImW^ML60ZA[^"
    "MM==:2;^MRCQ2VO^MVoRbMK^MXd8BJ_^M_X7mN7^M_a[:9g^MeR?mik^MfV4VYC^Mh?Tn=[^"
    "MhG^RAS^Mii=6UK^N5<UNYK^N7<mmUg^N8i[mf?^N96W6BW^N9<4JR_^N@2CjMK^NAO_AB?]"
    "NFLWZIk^NI@dB9K^NKUoAn3PNPT9Ze7^NSIX:i7^NT3i5Yo^NUHDj2G^NU_a1io^NYeMfFW^"
    "N[o[RJ;^Nc:9NN[^Ncm[V:S^NdThbRS^NfSUR1[^Ni@jREO^Nj0HnUG^O1fmjEO^O84NBJK^"
    "O;pc:9W^O<9Bj=K^OBakNN[^OGMm>IK^OIDPNFW^OYimRQC^O]1169g^O`nn:no^ObGgJY?^"
    "OeZojUK^Ol8cF>_^Om:dQjG^OoXn^9S^P02dj=_^P2hCNAW^P5X^IfC^P=4W2F_^P=:XNAS^"
    "P>6X=^7^P?VK6:S^PBEB29?^PCh2Ve;^PDDJZIO^PFTR1fC^PLElNlo^PWPE]Yg^PZMI^2C^"
    "P[AY^JO^P[RFMR;^P_n?Q]c^Pa06J9S^PbQMFIK^PdF2fBg^PhL9I]c^PhRh^FG^Po5M^FS^"
    "Q5=`Z9C^Q:4iZ5o^Q:LE]mO^Q@Y^JF[^QCQ^b6[^QD305EkYQEE`>=S^QF_kJZ[^QJC`]R7^"
    "QJPIb5[^QJ_nJJW^QJn;N1[^QKoXYjS^QR^0Va;^QRf:65g^QTTeeUk^QXY@^=_^Q]L1f:O^"
    "Q]REEak^Q^fa6>W^Q`?ZF]C^QcRbjEO^Qcd=RFg^QeGHJBc^Qf_Ue^7^QgQV2IG^QmJgjbc^"
    "Qn159Uc^R25P263^R3P?F;?^R4^3NF[^R4be6=_^R6nTYZ;^R=HhJJ3^REYg:FW^RJ=_J]?^"
    "RP[Rf:[^RRk6:JS^RRogb>3^RX9?I^3^RYf7>^c^RbL:V>K^RcYn^5O^RjINf2O^RnhUR6S^"
    "S73P]b[^S7@Kb:3^S839jZ_^S;DLJYO^S@Q3^^g^SAL_FBS^SD2YB5o^SH@3>5W^SpO7:MO^"
    "Sc9mJEG^SdFGiVW^Sf[J^^[^Shb@mf?^SiGF6BK^SkBZjRg^SkJdJFS^T1@:af?^T1`NEf3^"
    "T3IRFR[^T7NY2:O^T80bR>W^T8p3J2S^T>0dBCC^TE3nem[^TGiMJAK^TJYhAj3PTM82N=G^"
    "TNhR61O^TP:L6N[^TPgZ^=W^TS7b9R?^TTWU26_^TV^peA[WT]1I24c^T]K[::[^T_p<BAK^"
    "TaEp^6C^Tb<<M][^Td;;B4g^U0BcZN[^U0iBjB_^U45kQQ_^U;XKaQS^UAa0b=W^UGW51nS^"
    "UIZAF1k^ULGVJMG^UO3Q^1S^UR:JnF_^UR`X=e_^UUZhFF[^UVRWmZ_^UYe`R:_^UZFj:EO^"
    "UpGBUic^U_a8FB[^UbG2Aeg^UgZZmYo^UgbdMZ;^Um@TJ9S^V3@]fFc^V3gk2JK^V44f:5_^"
    "V8SlfEK^V8^X9J3pV:k5VBK^V<R_nMG^V@P]2>g^VDQ_mJK]VI_=JFW^VIco2A_^VIl8R9[^"
    "VMO?JFk^VV`oRQK^VXaGmMc^VZN5mj7^VZV?M>;pVZ[16BK^Va5LUnS^Vb>=5VG^VdpOMn3P"
    "Veppb>[^Vgl@6Jc^Vh11^Ig^Vjp6mF?^VmcT=^C^VnfA=bW^VoCG9^O^W1RXJaC^W6l^n2?^"
    "W7J>UNK^W7MDNBW^W8@fV6?^W;IgfFS^W<1NaZ;^W<>cZQK^W=T5RJ7^W@G^1Z;^WCi_N:[^"
    "WF9BbRW^WH7oR1S^WJeDVIK^WTJJj2_^WYXhBFS^W]W[N>S^WdF3IM[YWdK76AK^Wf<h^IK^"
    "Wi2GBIK^WjEc5b?^WmYWN=K^X;N?f1O^X=_E6Fo^X>HP2Nc^X>UK65k^X?Y82AS^X@KnF:W^"
    "XA8Xj^c^XBSH:bg^XFAD]b?^XFaX=ic^XN_>QfG^XPHBUZ3^XQ=H^9_^XTL]NAS^XW=8I^3^"
    "XY[BR9[^X^Y12F_^X^_2N9S^X_E[VZW^X_[2=f7^Xa:e:6O^XcE2b1;^XehdZIK^Xi>DZ_3^"
    "Xkj@26C^XoJKJQK^Y0VeiYo^Y4XfYZS^Y94_]b7^Y:5FaQk^Y:6VVIC^Y<f3^BS^YARYUYc^"
    "YD5gF=O^YEjLfFg^YJ7B^R[^YJ]On5_^YN<7FAG^YSlp:9g^YZlG5R3PYb>8NBW^YcJ@iMo^"
    "Yd4[ZAS^Yfj:>AW^Yhh0ee[^Yl4cb9c^YlRUR5W^Z5j`bUK^Z8:<JEK^Z:=Z^9[^Z<j]]jW^"
    "Z>HZVUG^Z?f61j;^Z@K;:J[^ZA^2jZk^ZBD@9a_^ZE7<jEO^ZI606EG^ZIXeI^G^ZSYj25k^"
    "ZVG?6=c^ZWcP>9O^Zp7cieg^Z]=NRV_^Z^mBJEo^Z_hefMW^ZaYER5S^ZecQj6G^Zg67Zfk^"
    "Zg>A:FG^ZhF_ZUC^ZmJOVYG^[1A9=eC^[2?lf:W^[4OP:FK^[4TAb9o^[5hIJY;^[85C=Ik^"
    "[?fH>A[^[FRHYnG^[Kmhf6S^[LbJjB?^[PK1b>W^[RaDNF7^[WHTZ9[^[[?>B=K^[]99NAS^"
    "[_fNNIO^[c19F:G^[idMB5[^[l;]^bc^[l^]JBS^p<@MVIG^p=Lh1J;^p>3Q:MK^pH1On=c^"
    "pJFZmf;^pLS8J>[^pMFZQnW^pV9bb^g^pVmDjVc^pWSR:5K^p_U>B;C^p`c2NF_^pc`HMj3P"
    "pf>RZIC^pfXHf1_^pk1gf=S^pl>BEV?^po8l>IK^]1^f6J_^]2L4^EW^]2]OInO^]3`<JIK^"
    "]6;o26S^]<D9bR[^]<RD^5c^]?05::[^]@kInRc^]E_UB4_^]MYQZBG^]Q2mZ6O^]RMpjBc^"
    "]Y71BQ?^]]=7f>W^]aUVfR[^]j3P^N_^^0ZMUm[^^2`;^:O^^3^dnF[^^44CEjC^^4E2=i_^"
    "^7?BFB_^^95eUmk^^;kD:EO^^<MKU^3P^=agEnG^^=kpV1[^^@iDYUk^^CkLB1[^^DkEIFG^"
    "^GHQ^2O^^KS[nNS^^NdnN=S^^Qe8EN;^^T1UbJ_^^ULE2RO^^Z8FfMK^^ZR=2:K^^j5c>:o^"
    "^ldZ:I7^_3p_YFG^_6ZOImG^_:;l^BW^_;8XBNS^_<2Omf?^_<?K6BS^_=boYn3P_=mdb1O^"
    "_>oAibW^_IPZ6R_^_IUK^E[^_WJ45mO^__8ORF3^_a0^M][^_g]pbR[^_lI^VEO^_mAFN1k^"
    "`4oajAS^`5j3FAO^`9AmN>S^`:P3^9W^`;=BFBO^`==H^]?^`>eW:5W^`Ej_N^_^`EoQ6=C^"
    "`JVaBIO^`TT`2AO^`VYX2MK^`]2Yf5O^`_Gdib7^`a3pb6W^`d[MUag^`eVC66K^`ge^]fC^"
    "`j39n:;^`oAWF:[^a0CXUbG^a2ab^5[^a617NA[^a8]:Qj?^a8aRI^C^a;?pRE_^a@=K2F[^"
    "a@CLN5W^aB9o^2_^aB_?:6O^aDiLf1;^aGM>ZI[^aI]F5V;^aJWiQ^K^aK`Z62S^aLkR^2C^"
    "aMNZ2>[^aM_FeVo^aR;?ibG^aSVlmm7^aT1?6Jc^aT>Siik^aWk@Yj;^aZY9]Z7^a^BD>Zg^"
    "a^JM^>C^ac1]j:G^agNffFg^ak[p^R[^anR1J2W^ao`QF=K^b2>AbFS^b42g=R3Pb5^_:6W^"
    "b<Pa5UW^b><XmjK^b@7[bM?^b@WSJ6K^bCbRNFS^bE3:N1_^bHNT>=W^bJe]26K^bMY=f9[^"
    "bXlV>9c^bY^VJAS^b[b4^9W^baoU:NW^bg5TeV;^bhP<J>[^bjZJ6MS^bnX55N3[c5>D61g^"
    "c7fgRBG^c7kY6=c^c9GjB1S^c<YjZIK^c>ahRV[^c?6m:2[^c@QpNAg^cC=_R5S^cGGkj:O^"
    "cHb[:BK^cQ3Yiag^cR`aZfk^cSdFf6O^cV3j>FO^cV8[bF7^cYY]=Ik^cZZDAIk^c`@=^i?^"
    "ccWc]Uo^cfHPZJ[^cmRBf6O^d2f=VBS^d49YN=[^d9pM2YK^d<^f^^k^d>]SN9[^dKHgB9[^"
    "dNC7JJ[^dT55j6W^dVSH=J7^dXpF6F_^d_8gR4o^d_Wk:IO^d`c=QR7^daejQZO^dbC0MBGZ"
    "deJM^2O^deYXU^O^djLmbJS^dk@OjNc^e4iBEj;^e<fhYf3PeA9XB;G^eEDbMV7^eGblZAO^"
    "eH:Zb6S^eH<bf1c^eKcoUZS^eOUgZ1S^ePWDb:S^ePXTV:O^eR1F9mk^eRO7f1_^eSC@:R[^"
    "eT0NbAW^eU>TnFc^eW`I66K^eY<R2a;^ep20Ve7^e]ELIR?^ealpUf?^ebOcn>[^egCoB4W^"
    "ehX6j9C^ei26miW^f1H9B^c^f2WGZ:K^f2XaFUG^f3KWZJ[^f9aAR5O^f:[KBEO^f<CaJ9c^"
    "f>aQf6S^fB4F=a[^fDa[AeS^fR<Eb1[^fR>gUm_^fUC>n>S^fUiL=i_^fXcpFF_^fYodeY_^"
    "fZZ?V1k^f[[p^6K^f]O^:AK^f^1eU1gVfbJ4^QK^ffAfN=_^fjkXQVC^fk082=[^fm6?je7^"
    "fn_`F5W^g0IHN9W^g6CPMn3^g70_2NS^g;p`fMK^g=]9B1O^g?IgAfG^g?p?b>_^gFRO>QG^"
    "gLc?eJG^gLlc2=_^gW4DnM;^gYicR]C^g]ce6FS^giZDf>S^gk546N_^gk9e^E_^h0PTB=O^"
    "h@piVIc^hG2SN6W^hIB6bN_^hK@cR5W^hMn8VAW^hQ_^V=K^hS^]Ij3^hVT;jEO^hYV]BBS^"
    "hZ5`n^k^h[FHnYC^hpapF>W^h`J1>5S^h`J8j]C^hgO9Nbc^hhh2^e?^hl;;BEO^i69:29O^"
    "i>W3j5S^i@l>ib7^iBX6f:[^iCTbFB_^iIJ8]fG^iJH=n]G^iN>gV=G^iPf1J>W^iRf7be7^"
    "iTF<^9W^iV:b>6o^iVVoj27^iWUQNAW^ipd6VES^i`3e66_^iaae2FO^iagfN=W^ibcfAbC^"
    "idCY:2O^ifMff97^ifefmJK^igPAaeS^ihDJ2Vc^ihQ^i^G^ii1XZIO^ikA`5^C^io@6jUK^"
    "j16l9Yg^j3_YibC^j5;G1m3^j5UY6JS^j<E9=e3^j?ng^:C^j@FCfBc^jDV7j:K^jGXQV2O^"
    "jI3@fJ_^jIln>bc^jJS;MQc^jM9GIR3PjM@6bFS^jQ@9b:K^jSb[bBW^jUWAAU[^jY>;nQC^"
    "jYjn^=O^j[51=Yg^jb;mJ:C^jeFlN>S^jf_e^]C^jj2n>=W^jjDHjBc^jjjV9iW^jlJ72:S^"
    "jo=Wf5[^joM<NFS^jo[IR1_^jom6>E_^k3k3Bbk^k4Q@Qao^k72PV6S^k;C0JIc^k=FNb9_^"
    "k@<521S^kEJRJ1[^kJ4VJFW^kL6ZVQG^kL>d6AO^kP<a:>_^kP]jbY;^kTU@:fg^kVb^5mc^"
    "kYKARBO^kYP36=o^k]3:2bg^k`FBVJ[^kb66NEc^kcWU6IO^khlEj:K^kj::65S^kjG5:>C^"
    "l2X3ib7^l:H;1V?^l;>7AAk^l>SEBjk^lAdWbi7^lG1?6o7^lG9HV:G^lGda:Ng^lGlj^N_^"
    "lO6pj2O^lSUcRBO^l[@g6YC^l^C@^J[^ld]p>V[^liDlJZC^liZ8^E?^llmAB=_^lm;V2^c^"
    "loYhIEc^logQJFW^m19[F:S^m1bf>Nc^m3@c5I[Tm5hlf9c^m6V;J6W^m9i]^Jg^m>Pmj:W^"
    "m@]AR8g^mA<E>MO^mN4T6BW^mSX=b9K^mUmHeb3Pm]>h9Q[^m^KBYZ7^mb^2BCK^md9;EjW^"
    "mhpGe]_^miGFZ=S^n4gZ:F[^n6bnnF[^n8jHbR[^n=VJVe?^nB8W9Mc]nB8i::C^nFklF9S^"
    "nGTIFEK^nHhIBEg^nPVlJ>7^nRga^9O^nT;aYnG^nY4fBIO^np?eBIK^n]2cA^G^n`Ekf6S^"
    "nfACYfK^nlDC6:K^o36E1Qc^o3`_b1c^o3cAUmc^o78Ea:7[o7Mf=i_^o8mG6:K^o:H6J>c^"
    "o;T>eYg^o<>YV1g^o>`CJ6g^o?48:EK^oAK@n6S^oD28YUo^oG0hJB[^oG4@Aic^oG>=>:S^"
    "oJEZQ^?^oK1kEVC^oLTR6=_^oSoJbR[^oXU96N[^oYea6=c^o]A:fAK^o_ASAiS^oa?n2IK^"
    "oei`1NG^of8ji^O^ogGJfAG^oh^HMfO^ojaTbEW^om>WB2o^onQ=2A_^0200023P02T0023P"
    "04401>3P04P0123P06400>3P06P0063P08X00:3P09000:3P0R000B3P0RT00>3P1200023P"
    "12T00>3P13<00B3P13X00>3P16P00J3P17800F3P1;000J3P1R00023P1RT00>3P1VP00B3P"
    "22000:3P3200063P3R00063P40000F3P42000J3P44400:3P5;000B3P@000023P@200063P"
    "A2000F3PAR000>3PB2000:3PL0000:3PL2000>3PP200123PP6400j3PP6P01n3PP8X00F3P"
    "P900023PP;000>3PPR001V3PPY000F3PQ0001V3PQ1<01J3PQ1X01>3PQ200163PQ3<01V3P"
    "Q3X01B3PQ4P01b3PQ5801F3PQ640123PQ7801^3PQ9000:3PQ;00063PQP001N3PQPT01J3P"
    "QR001F3PQRT01^3PQTP01>3PQVP01V3PR2001J3PR8X00J3PR9000:3PS0001:3PS1<01>3P"
    "S1X0163PS5801:3PS9000>3PSP001B3PSPT01N3PSTP01J3PT6400n3PT9000J3PU5801N3P"
    "U6400j3PU6P01F3PU9000:3PU;000>3PUV401B3PW9000F3PWT401Z3PX8X00N3PX9000N3P"
    "XY000F3PY9000B3PZ8X00N3PZY000R3P[9000B3P[X<00V3P]6400R3P`2000j3P`9000N3P"
    "a200163Pa5801>3Pa9000Z3Pc5801J3PcP001b3Pe9000R3Ph8X00N3Ph9000J3Ph:X00R3P"
    "i9000B3PiZ<00N3Pj8X00R3Pk900063PkP000B3Pl2000N3Pm1<00R3Pm2000N3PmP000B3P"
    "mR000J3Po1<00J3PoP00063P0a@00R3P0n@0123P1<000V3P1C@0163P1O@01R3P1`@00V3P"
    "1d@00n3P1o000Z3P26@00V3P2O@0163P2Y@00^3P39@00b3P3RP00V3P3]@01:3P3a000^3P"
    "48000B3P55001J3P5WP00n3P5c`00^3P5hP00V3P6hP00^3P6h`00F3P6m`00B3P7IP01F3P"
    "7Q`00j3P7iP00R3P7o@00V3P87P00J3P8@P00R3P8DP00^3P8[`00j3P8_@0123P8n000Z3P"
    "9D@00b3P9N000N3P9U@00f3P9pP00^3P:1`00V3P:2P00n3P:2`00n3P;2@00N3P<E@00b3P"
    "<Q@00^3P=NP00b3P>pP00:3P?P001>3P?n001B3P@5`01F3P@D@00^3P@]P00R3P@j00163P"
    "A8P00F3PB0@00Z3PB5P00N3PBC000V3PBH`0163PBK`0123PBW@0163PB^`00Z3PBfP00n3P"
    "CYP00f3PCcP01V3PCh001:3PDR@00R3PDZ`00>3PEE001N3PE`@00f3PFV001>3PF]@01B3P"
    "Fh`00J3PHM@00R3PH[`00Z3PHi000^3PHoP00N3PI7P00^3PIH`00Z3PIQP00R3PIWP00^3P"
    "JQP00j3PK7`00b3PK?`0163PLPP00N3PLWP00j3PLY000N3PLgP0163PN9@00f3PN?001N3P"
    "NSP01F3PNb00163PNmP0163POG000V3POI@00b3POW`00F3POi001J3PPQP0123PQB00123P"
    "RQ@00>3PR`P00V3PS9@00B3PSIP01N3PS]P00B3PT0`00j3PTN`00b3PU0P00N3PU3P01J3P"
    "U?000j3PUK`01F3PUi@00B3PVQP00j3PV`000^3PVaP00V3PWb@00B3PX0`00:3PX=@00^3P"
    "YRP00^3PZ9@00^3P[9P00R3P[B`00^3P[G`00b3P[P`00Z3P[b`01F3Pp=P00V3PpJ000Z3P"
    "p^000Z3Ppg`0163PplP00N3P^BP00J3P^DP00f3P^^@01V3P_NP00V3P_T@00^3P`J000^3P"
    "`V@00f3Pa1@01>3Pb8001j3Pc>@00R3Pc``00^3Pcj`00f3Pd;`01B3PdO000b3PdV`0163P"
    "db000R3Pe=000J3Pe@`00Z3PeF`01V3PeK`00Z3PeS000b3PeY000F3Pe_P00N3Pen000>3P"
    "fN000b3PfpP00j3Pg8000j3Pge`00V3Ph4@0163PhH000F3Phc000F3PiJ@00f3PiS@00V3P"
    "iX@00^3Pim@01>3Pj200163PjA000n3PjQ@01R3PjU`00V3Pjo@00Z3Pk=`00R3PkD000b3P"
    "kG000>3Pk]@00J3Pl?`00>3PlT`00n3PlY000Z3Plp001^3PlgP00R3Pn2000b3Pn:P00N3P"
    "nF001J3PoB000b3PoPP00j3P0J000V3P0PP01F3P0W000f3P0[000V3P0]001:3P15`00n3P"
    "1M`00n3P1Q000R3P1c@00j3P1g`00j3P29001>3P2FP0163P2MP00f3P2V@00R3P31`00f3P"
    "36P00b3P41P00f3P4E`00j3P4H@00f3P4J000f3P4pP00n3P4o000B3P53`00b3P56P00Z3P"
    "5D000j3P5EP00n3P5P000V3P5S00123P5XP00b3P5f`00j3P5l00123P5m@00n3P66@00Z3P"
    "6>P00j3P6J`00n3P6Q000^3P6S000f3P6Y`00b3P6a@00j3P6l@00n3P7BP00f3P7JP00n3P"
    "7U000V3P87001B3P8k000j3P8l000b3P9;@00f3P9O`01R3P9YP00b3P9Y`00j3P9g001V3P"
    "9oP00^3P:6`01Z3P:V000n3P:[P01F3P:l`01:3P:m000f3P;AP00f3P;O001:3P<?@00f3P"
    "<V000b3P<i000Z3P==P0123P=C000j3P=CP00^3P=R`01>3P=S001R3P=p`00j3P=`@00f3P"
    "=lP00V3P>8000j3P>]000n3P>mP00F3P?]`01:3P@V`00j3P@`P0123P@b@00b3P@cP0123P"
    "@mP00b3PA[000^3PB3`0123PB4`01:3PB9000^3PB=@00b3PBg000f3PC8@0123PCI@01:3P"
    "CWP00J3PC_000n3PCfP00V3PCnP01>3PD5P00j3PD=000n3PDE001F3PDE@00f3PDjP00R3P"
    "E2@01V3PEH000f3PEI`00f3PE_@00f3PF0000f3PFG000f3PFM@00Z3PFO@00n3PFe@00f3P"
    "G9@0123PG?P00f3PGG`00^3PGW`01:3PG[`00n3PG^@00j3PGj@01V3PHI001F3PHZ@00^3P"
    "Hg@00b3PIj@00n3PJQ000f3PJX@00j3PKD000j3PKV@01>3PKX`00b3PL6`0163PL;`01:3P"
    "LA@00^3PLS000Z3PM7000f3PM@P00V3PMC@0163PMX`00f3PMj@00f3PMkP00b3PN6P00j3P"
    "N=`01:3PNK@00^3PNZ`00j3PN[@0123PN_P00f3PNiP01B3PNm`00b3PO>@01R3POBP00^3P"
    "OF`0163POS`00f3POX@00b3POc`01R3POg000j3PPA@00^3PP]@00n3PQG`01:3PQJ@01:3P"
    "QK000^3PQO@00f3PQU`00V3PR3000j3PRc`00J3PRe`00f3PRl`00f3PS7`00V3PS8@00n3P"
    "SJP00V3PSL@00j3PSMP01J3PSOP00R3PSU000b3PT0@00N3PT;@01F3PTO000n3PTTP00f3P"
    "TVP00^3PT``00V3PTcP00^3PTe`00Z3PTm`00n3PU0@00N3PUL00123PUM@0123PUQ000V3P"
    "US000V3PV7@00f3PVEP01B3PVE`00f3PVF`0123PVG`00V3PVI`00n3PV`P00^3PW5P0123P"
    "W7@00^3PW?@00^3PWJ`01R3PWR`00j3PX:P00f3PXA@00Z3PXI@00f3PYL`0123PYi`00n3P"
    "ZC@00j3PZP@00b3PZiP0123PZi`01:3PZn@00Z3P[5@0163P[H`00n3P[Y000V3P[Z@00Z3P"
    "[j@00b3P[k`00j3PpiP00b3P]@000j3P]I00163P]]P00n3P^CP00f3P^FP00n3P^N000b3P"
    "^OP01B3P^X000j3P^pP00b3P^k000J3P_9`00b3P_DP01:3P_R@00R3P_d`00f3P`4P00n3P"
    "`9`01>3P`R00123Pa8P01J3Pa[`00^3Pa`P01:3PbT`00:3PcI@01:3PcI`00Z3Pc[000N3P"
    "c]`01J3PcoP00b3Pd2001:3Pd7000^3PdDP01>3PdV@00V3Pe000123PeH`0163PeK`00^3P"
    "e`000^3PejP01F3PelP00b3Pf4000j3Pf@000f3PfA001B3PfGP00j3PfH@00f3PfQP00b3P"
    "fV@00^3Pfc000R3Pfn000j3Pfo000^3Pg3P00j3PgL000V3Ph1@00:3Ph3P01F3PhR`0123P"
    "hY`0123Phi`00f3PiRP00b3PiY000Z3PiYP00b3PipP0123Pi`@0223PieP01>3PjC`00n3P"
    "jJ001:3PjV`00f3Pji000n3Pk1000N3Pl8@00f3Pl:`00Z3Pl?`0163PliP00b3PlkP0123P"
    "m:@00Z3Pm:P00f3Pme`01>3Pmh`00^3Pn<`0163Pn?P00b3PnYP00^3Po4P00b3Po5@00j3P"
    "o<@0123PoC000^3PoD000^3Po`@00V3PobP01B3Pol@00n3P"
    "";

const std::array<std::array<std::int16_t, 32>, 2> kTurnWeights = {{
    {685, 1191, 257, 1242, 1932, 802, 1009, 387, 762, 828,
     669, 418, 255, 712, 0, 0, -426, -425, -479, -973,
     -683, -265, -144, 438, -204, -525, -389, 253, -130, -130,
     -130, -130},
    {1118, 1115, 315, 1063, 1451, 1102, 1288, 665, 475, 939,
     1030, 682, -132, 0, 0, 0, -292, -147, -230, -597,
     -380, -251, -153, 214, 18, -534, -271, 77, -12, -12,
     -12, -12},
}};

const std::array<std::array<std::int16_t, 8>, 1> kStartWeights = {{
    {1830, 1551, 1211, 0, 0, 0, 0, 0},
}};

const std::array<std::array<std::uint16_t, 2>, kFlags> kFlagStart = {{
    {655, 0},    {655, 0},    {655, 0},    {62, 20},
    {128, 20},    {132, 20},    {15, 20},    {47, 20},
    {450, 2},    {90, 20},    {43, 20},    {69, 20},
    {79, 20},    {372, 20},    {133, 20},    {4, 20},
    {1253, 20},    {431, 20},    {72, 20},    {36, 20},
    {96, 20},    {85, 20},    {108, 20},    {104, 20},
    {1395, 20},    {214, 20},    {400, 20},    {186, 20},
    {85, 20},    {183, 20},    {6, 20},    {209, 20},
    {207, 20},    {655, 0},    {655, 0},    {274, 4},
    {193, 15},    {189, 18},    {168, 18},    {49, 20},
    {2274, 20},    {350, 4},    {236, 15},    {102, 20},
    {115, 20},    {85, 20},    {63, 20},    {43, 20},
    {1598, 20},    {187, 20},    {82, 20},    {425, 20},
    {38, 20},    {27, 20},    {43, 20},    {29, 20},
    {4778, 20},    {1726, 20},    {208, 20},    {247, 20},
    {13, 20},    {25, 20},    {28, 20},    {10, 20},
    {348, 6},    {655, 0},    {655, 0},    {655, 0},
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
    {1437, 20},    {289, 8},    {248, 8},    {102, 20},
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
    {204, 20},    {655, 0},    {655, 0},    {371, 3},
    {450, 2},    {296, 6},    {371, 3},    {178, 20},
    {159, 20},    {519, 1},    {350, 4},    {129, 20},
    {149, 20},    {217, 12},    {289, 8},    {57, 20},
    {2161, 20},    {145, 19},    {876, 20},    {312, 20},
    {32, 20},    {37, 20},    {116, 20},    {13, 20},
    {9168, 20},    {4354, 20},    {880, 20},    {406, 20},
    {9, 20},    {1236, 20},    {106, 20},    {6, 20},
    {6797, 20},    {655, 0},    {655, 0},    {655, 0},
    {382, 4},    {265, 7},    {304, 5},    {102, 20},
    {3595, 13},    {519, 1},    {450, 2},    {185, 13},
    {308, 8},    {450, 2},    {519, 1},    {10, 20},
    {5429, 20},    {175, 20},    {128, 20},    {31, 20},
    {85, 20},    {100, 20},    {244, 7},    {5, 20},
    {9593, 20},    {5554, 20},    {2466, 20},    {2136, 20},
    {586, 20},    {1153, 20},    {121, 20},    {2, 20},
    {655, 0},    {655, 0},    {655, 0},    {373, 20},
    {180, 20},    {67, 20},    {82, 20},    {28, 20},
    {223, 20},    {732, 20},    {647, 20},    {765, 20},
    {179, 20},    {197, 20},    {252, 20},    {84, 20},
    {2393, 20},    {1690, 20},    {1232, 20},    {744, 20},
    {291, 20},    {345, 20},    {256, 20},    {267, 20},
    {4853, 20},    {1540, 20},    {773, 20},    {535, 20},
    {252, 20},    {253, 20},    {243, 20},    {265, 20},
    {2310, 20},    {655, 0},    {655, 0},    {1684, 20},
    {1240, 20},    {404, 20},    {75, 20},    {324, 20},
    {2410, 20},    {2890, 20},    {1762, 20},    {1123, 20},
    {138, 20},    {287, 20},    {563, 20},    {589, 20},
    {5789, 20},    {2617, 20},    {1601, 20},    {1223, 20},
    {181, 20},    {506, 20},    {11, 20},    {310, 20},
    {10388, 20},    {3070, 20},    {1150, 20},    {951, 20},
    {505, 20},    {926, 20},    {973, 20},    {11, 20},
    {5753, 20},    {655, 0},    {655, 0},    {335, 5},
    {1987, 20},    {245, 15},    {247, 13},    {1896, 20},
    {5627, 20},    {6214, 5},    {2620, 19},    {2392, 20},
    {1606, 20},    {160, 20},    {165, 17},    {87, 20},
    {9902, 20},    {1368, 20},    {1764, 20},    {1074, 20},
    {430, 20},    {233, 20},    {73, 20},    {324, 20},
    {13738, 20},    {3771, 20},    {1595, 20},    {1682, 20},
    {795, 20},    {18, 20},    {714, 20},    {10, 20},
    {16214, 20},    {655, 0},    {655, 0},    {655, 0},
    {4340, 8},    {248, 9},    {272, 6},    {2251, 18},
    {14226, 20},    {382, 4},    {156, 20},    {631, 20},
    {731, 20},    {2276, 20},    {245, 7},    {118, 20},
    {19798, 20},    {1464, 20},    {1688, 20},    {2077, 20},
    {804, 20},    {803, 20},    {1137, 20},    {19, 20},
    {19330, 20},    {6395, 20},    {3376, 20},    {4061, 20},
    {3667, 20},    {6280, 20},    {16826, 20},    {501, 20},
    {655, 0},    {655, 0},    {655, 0},    {478, 20},
    {324, 20},    {133, 20},    {103, 20},    {150, 20},
    {307, 20},    {1059, 20},    {646, 20},    {672, 20},
    {311, 20},    {180, 20},    {125, 20},    {85, 20},
    {2211, 20},    {1817, 20},    {1002, 20},    {646, 20},
    {509, 20},    {359, 20},    {112, 20},    {81, 20},
    {3793, 20},    {1846, 20},    {1458, 20},    {984, 20},
    {774, 20},    {519, 20},    {149, 20},    {109, 20},
    {4730, 20},    {655, 0},    {655, 0},    {1141, 20},
    {1758, 20},    {1492, 20},    {809, 20},    {356, 20},
    {6007, 20},    {1888, 20},    {1276, 20},    {1138, 20},
    {1119, 20},    {1068, 20},    {550, 20},    {100, 20},
    {10247, 20},    {3181, 20},    {2183, 20},    {1561, 20},
    {1229, 20},    {1413, 20},    {405, 20},    {130, 20},
    {11532, 20},    {3541, 20},    {2263, 20},    {2029, 20},
    {1469, 20},    {1321, 20},    {512, 20},    {134, 20},
    {9572, 20},    {655, 0},    {655, 0},    {116, 20},
    {3294, 20},    {2325, 20},    {1610, 20},    {677, 20},
    {15054, 20},    {4691, 20},    {3132, 20},    {2162, 20},
    {1776, 20},    {1565, 20},    {1265, 20},    {89, 20},
    {12769, 20},    {3785, 20},    {2505, 20},    {1644, 20},
    {1577, 20},    {1600, 20},    {401, 20},    {108, 20},
    {12895, 20},    {5677, 20},    {2727, 20},    {2825, 20},
    {2675, 20},    {1952, 20},    {960, 20},    {369, 20},
    {21447, 20},    {655, 0},    {655, 0},    {6497, 14},
    {3012, 20},    {3637, 20},    {869, 20},    {1726, 20},
    {22587, 20},    {6047, 15},    {2103, 20},    {2084, 20},
    {3366, 20},    {5310, 20},    {1832, 20},    {532, 20},
    {20307, 20},    {7309, 20},    {7240, 20},    {4215, 20},
    {3254, 20},    {3700, 20},    {1128, 20},    {399, 20},
    {19598, 20},    {7108, 20},    {6951, 20},    {8816, 20},
    {4386, 20},    {2775, 20},    {1791, 20},    {524, 20},
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
    {4700, 20},    {655, 0},    {7510, 5},    {238, 7},
    {193, 13},    {265, 7},    {184, 10},    {267, 8},
    {6454, 20},    {3022, 19},    {2613, 20},    {1875, 20},
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
    {13839, 20},    {519, 1},    {7510, 5},    {3341, 11},
    {168, 16},    {213, 11},    {2611, 20},    {1200, 20},
    {17715, 20},    {9991, 20},    {7632, 20},    {5037, 20},
    {4514, 20},    {4818, 20},    {5860, 20},    {577, 20},
    {20540, 20},    {11931, 20},    {16603, 20},    {11399, 20},
    {8813, 20},    {8311, 20},    {2058, 20},    {1011, 20},
    {22582, 20},    {655, 0},    {655, 0},    {519, 1},
    {403, 2},    {15579, 4},    {6597, 7},    {10690, 2},
    {17868, 20},    {655, 0},    {267, 6},    {7776, 14},
    {141, 20},    {8601, 3},    {159, 10},    {1853, 20},
    {20439, 20},    {6612, 20},    {12109, 20},    {7855, 20},
    {5534, 20},    {15401, 13},    {7609, 20},    {5653, 20},
    {19998, 20},    {17030, 20},    {15991, 20},    {12567, 20},
    {10155, 20},    {16609, 20},    {7215, 20},    {1153, 20},
    {655, 0},    {655, 0},    {655, 0},    {723, 20},
    {443, 20},    {349, 20},    {240, 20},    {185, 20},
    {199, 20},    {1719, 20},    {1850, 20},    {995, 20},
    {738, 20},    {1139, 20},    {938, 20},    {770, 20},
    {4372, 20},    {5040, 20},    {2339, 20},    {2003, 20},
    {1402, 20},    {2147, 20},    {879, 20},    {1060, 20},
    {11024, 20},    {9494, 20},    {4250, 20},    {3055, 20},
    {1239, 20},    {1361, 20},    {1264, 20},    {468, 20},
    {1656, 20},    {655, 0},    {655, 0},    {1267, 20},
    {58, 20},    {2400, 20},    {2310, 20},    {1828, 20},
    {7477, 20},    {158, 12},    {2721, 20},    {1635, 20},
    {1221, 20},    {1877, 20},    {432, 20},    {1333, 20},
    {12176, 20},    {8677, 20},    {3707, 20},    {5176, 20},
    {2403, 20},    {1701, 20},    {1820, 20},    {2251, 20},
    {23911, 20},    {14856, 20},    {9034, 20},    {9483, 20},
    {5730, 20},    {2354, 20},    {4968, 20},    {3706, 20},
    {9173, 20},    {655, 0},    {655, 0},    {519, 1},
    {222, 9},    {655, 0},    {12876, 6},    {6187, 5},
    {18889, 20},    {519, 1},    {267, 6},    {4710, 11},
    {2837, 19},    {169, 13},    {107, 20},    {77, 20},
    {15449, 20},    {10235, 20},    {5645, 20},    {10040, 20},
    {3244, 20},    {4807, 20},    {105, 20},    {1010, 20},
    {27077, 20},    {18782, 20},    {9579, 20},    {14619, 20},
    {12969, 20},    {4262, 20},    {3992, 9},    {4272, 12},
    {28011, 20},    {655, 0},    {655, 0},    {25610, 2},
    {8596, 5},    {14172, 1},    {244, 8},    {25610, 2},
    {40197, 20},    {655, 0},    {8721, 4},    {15871, 12},
    {6929, 16},    {371, 3},    {4361, 12},    {238, 7},
    {27456, 20},    {22320, 20},    {11112, 20},    {13169, 20},
    {8586, 20},    {2814, 20},    {10256, 20},    {3712, 20},
    {26184, 20},    {23862, 20},    {18651, 20},    {21560, 20},
    {10780, 20},    {3797, 12},    {28880, 20},    {11320, 20},
    {655, 0},    {655, 0},    {655, 0},    {864, 20},
    {506, 20},    {414, 20},    {442, 20},    {259, 20},
    {238, 20},    {961, 20},    {2455, 20},    {1665, 20},
    {941, 20},    {281, 20},    {403, 20},    {248, 20},
    {3815, 20},    {3049, 20},    {2761, 20},    {1792, 20},
    {932, 20},    {278, 20},    {359, 20},    {408, 20},
    {5938, 20},    {5502, 20},    {1956, 20},    {2168, 20},
    {882, 20},    {711, 20},    {439, 20},    {301, 20},
    {2713, 20},    {655, 0},    {655, 0},    {1129, 20},
    {1426, 20},    {159, 20},    {390, 20},    {812, 20},
    {2963, 20},    {2260, 20},    {2057, 20},    {1939, 20},
    {1366, 20},    {377, 20},    {192, 20},    {104, 20},
    {6577, 20},    {2681, 20},    {2299, 20},    {2690, 20},
    {1678, 20},    {445, 20},    {267, 20},    {720, 20},
    {13617, 20},    {7152, 20},    {4724, 20},    {4394, 20},
    {1848, 20},    {869, 20},    {1402, 20},    {467, 20},
    {6141, 20},    {655, 0},    {655, 0},    {655, 0},
    {4475, 12},    {165, 10},    {117, 18},    {2625, 20},
    {7130, 20},    {5416, 6},    {128, 16},    {3148, 20},
    {1730, 20},    {23, 20},    {577, 20},    {291, 20},
    {6825, 20},    {2209, 20},    {3226, 20},    {3085, 20},
    {1375, 20},    {1038, 20},    {109, 20},    {391, 20},
    {18224, 20},    {7675, 20},    {4386, 20},    {6962, 20},
    {2666, 20},    {1077, 20},    {1806, 20},    {1113, 20},
    {24127, 20},    {655, 0},    {655, 0},    {9416, 4},
    {164, 10},    {655, 0},    {14988, 20},    {7738, 20},
    {28384, 20},    {655, 0},    {2892, 20},    {13725, 20},
    {7448, 20},    {59, 20},    {3505, 20},    {2940, 20},
    {19018, 20},    {4236, 20},    {6397, 20},    {8113, 20},
    {5635, 20},    {1660, 20},    {1651, 20},    {1524, 20},
    {25842, 20},    {13491, 20},    {9509, 20},    {11307, 20},
    {5094, 20},    {1608, 20},    {4073, 20},    {2347, 20},
    {655, 0},    {655, 0},    {655, 0},    {655, 0},
    {655, 0},    {655, 0},    {164, 20},    {655, 0},
    {3268, 20},    {655, 0},    {10940, 20},    {655, 0},
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
}};

}  // namespace unstep::codec::warm
