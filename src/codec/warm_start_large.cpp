// Made by tests/bench/train_warm_start.sh; do not edit.
// clang-format off
#include "codec/warm_start.h"

namespace unstep::codec::warm {

const Table kLarge = {
    {{
    647, 469, 261, 170, 158, 514, 322, 210, 259, 406, 315, 1120, 636, 523, 428, 84, 141, 237,
    }},
    "00001ZC^06aDZEG^072mE]o^0?P6V5[^0?^4bNS^0B[oiZ;^0DClFJ[^0K`fBIK^0MhXnRW^"
    "0Q_i9m_^0jpX6fo^0oJPBR[^16ndnQ7^1<:;nNS^1RAJan_^1U0A^EG^1_lPR=S^1aYkBMG^"
    "1i]X]ao^1oVFR^g^2MJI5bC^2X:12Rk^2YPDb1C^2a^]ZFS^2dBJ^VW^2jglJQK^32lT5]c^"
    "35mU2:_^36CVnUK^36G=J6W^39=Zj:[^39M<EZK^3;58bRO^3<KYRNS^3BOV]a[^3B[p]j?^"
    "3P6^NVc^3QV<a^K^3WB`bIO^3pR3bA_^3_H1ifW^3hf3^Fc^46A5Ij[^4CH>]f?^4D4C:V[^"
    "4Ee[mfO^4KABnJW^4OJRJYC^4ZCc2:K^4b<VbNO^4c9kVEG^4f3dmZC^4j<^JE_^5@pgQRK]"
    "5L>;mbK^5M<AYZ7^5XlCUb;^5_RMQZC^5lmfF^c^5nh52B[^5o3i1Yo^6Jn7ZEO^6^O7eVO^"
    "6kcL]n3^7@DiBUO^7LINBAg^7LeP^IO^7VJ=F=C^7WaX>Z[^7`g]1mc^7aRVjQK^7fA`2EO^"
    "7gY7JFO^7hTTNN_^80_4i]S^83><Mmc^870EUi[^87l4^YC^8?Alj:3^8AeAF=K^8McNJ>_^"
    "8[8P1VO^8k4H5Yc^9<;:UUc^9A[OjVk^9Fe>FMK^9K1T^V_^9`[UJAO^9ckA>N[^9hINba?^"
    "9kg^j6K^:23=2a7^::7d^=G^:>O9N5k^:CooA^g^:DOQJjk^:L?RfMO^:TnDbAO^:YbLU]k^"
    ";1GX5nS^;5WSiIOZ;703IY;^;MIfR:[^;aJX:1o^;jNOjU?^;j^;:];^<3T=Q^W^<5MH=YW^"
    "<61pBEO^<7HBfe;^<9f_R1W^<;j72Nc^<B44bF;^<DQ:f:S^<DXhnNO^<SBneU[^<TC6bES^"
    "<p3;NMG^<c61NR[^<fUSi^7^<j[QanW^<mW`ZAG^=0G6:YC^=7IYM^3^=7QGUZ7^=BJ8nBS^"
    "=Ee9J>W^=MEPV>[^=UOG>a?^=XAKfFc^=YHniag^=[U[jMO^=`KlB2S^=`P?FIS^=gXl1ZC^"
    "=hTOmf[^=mMMEac^=mX7ZR_^>7U6n]?^>=EU5iS^>GdMNFO^>Lm^Ib7^>P1^^QS^>SbNZ>c^"
    ">XW3Z^c^>^[0f5O^>`C<ZEK^>mndJBW^?4pWFMK^?G39BNc^?H=Y2Zg^?I0R2QK^?K?^9Uk^"
    "?ONcF=[^?XP]:J[^?b5IbVW^@9TG22W^@>H0jV_^@L=aNBS^@Q;YbAG^@_`<FN_^@lLeYak^"
    "@n4b6:o^@o<mRBc^A0fAUYk^A;k5>F[^A>5>f:W^AGF_bB[^AXDHRQC^Ae`K2^c^AhEiU^C^"
    "AmU<V2W^B0I=nJS^B384fQC^BLQ=AU_^BQM7F9O^BSFj:^_^BS_SUNK^C3m2Jbc^C;?g=jK^"
    "CBb>Z9C^CGQ4A^;^CTTQ5fS^C[oC5B7VCkWUf1S^D3K=:JW^D5Z]BQK^D:^h1RG^DE:iU^;^"
    "DVp>V2?^E38K2NG^E7G1]iW^EDYjIVGpELfPB>W^EZcWB^_^E^VN]M_^EkK4=Qo^EoZ9J5W^"
    "F6hfJ=W^F?^niVG^FFPCR=O^FL<me]g^FOT]ZQC^FPE5]^C^FRhJ:Rg^FZPe:Zc^F]7nmU_^"
    "Fa2ARMS^Fa@iEZ3^FbRX2QG^FcZSmUk^FeJOS@c^Fi0ln9O^FjVn:9O^Flc65]_^G0PA6Vc^"
    "G6T>AYg^G:NPfIG^GFT8n:[^GFiUFAS^GWhG:B_^GXj[jk7^Gdc:J5O^GhA`bIO^H5SO9QK^"
    "H6H>=^S^H9756MG^H9LWUfK^H@aU6YK^HFVcBU?^HORBB5g^HPTT2:[^HSCJjEK^HYCEnNg^"
    "H`32VE?^H`f2VR_^HlXd>Jc^I:=KYm[^I>[Y>Zk^IBJ`j9_^IG>^Fbg^II<;AQ_^ISYZmMg^"
    "Ij`oB>g^Il``VZS^Imo=Ie[^In2bFE?^IncQ1jW^J0Qc5ZG^J2M`nBS^J;]Cn>[^J<NVbAO^"
    "JF?^mac^JPA_2MG^JS7=UUk^JVR4AfG^JXX7n>_^J`H<VF_^JeF?U^?^Jmd9MYo^K0=d1ZC^"
    "K4p7BRo^K>ZiN>S^KGJ2ZQG^KRQ]jJO^KVXMQV3^KYdHIbW^Kde@MjS^KfRP2>K^KlXd^R[^"
    "L1SH9^C^L9O[M^C^L;YoNQC^LRc;]jW^LU6>aeK^LUP5nUG^L]eVa^C^L_jDmJS^L`VINRW^"
    "La4gRFS^LklXZYK^M6eJ2QC^M@4b1Q[^MA=dVZc^MG?>QZK^MQREj5S^MX@LfIW^MY`Qb5O^"
    "MZVm2^k^M`Ql:Zc^Mc2IV9K^MgPW:N_^N6ZX:Ng^N91eM]k^N961nNO^N:H3ZU7^N>Kjn>[^"
    "N?1166O^NDnPMaO^NFpC6B[^NYeMf^g^N_LNm^G^N_e`6a?^NfnajZW^O1iO]b?^O6O2Y^?^"
    "O:GIQ^;^OiGQEZ3^OnZWN>[^P2lCZ9G^P>>=Z1g^P?VK6;7^P@0=eQc^PBcfFEG^PE32IYo^"
    "PE8GVUG^PG==VAK^PJlEF6W^PL0DAESVPYLM9Ig^P`YLi]W^PcbGJQK^PjETZ:[^Q3BSYYc^"
    "Q3nX:V[^Q@SRZNC^QAefiYk^QGVNEN7^QO3InEW^QS4@REO^QX]@iUW^Q^=V>^_^QcGDZIS^"
    "QgSZnV[^Qhia25S^Qjco]Uc^R9o^N2c^R:AHZQK^R==[^AS^RBF0EeW^RD@?1]g^RDkU6]?^"
    "RF]f6FW^RNUCFU?^RO<oamc^RVYk2AG^R[3BB1W^Rd25^IG^RfH]nNc^S1PK6M?^S5[L2YC^"
    "S>J=n=K^SFjYY^?^SG<djNW^SaI:ZV[^Sj7lVRW^T:6>Y]o^T;=gRF[^T?VNJIO^T@]B>bo^"
    "TFDREiS^TG@ANY?^TGko=f;^TJYhAZ;^TQ3Z]J7WTSjI6Y;^Ta3A6BC^Tc8QN9[^TfgY9fK^"
    "TkD=2Z_^U02;R1k^U0e=6A[^UFmOJY;^UG:7nJW^UI8?UnS^UNDgnUO^USk_]ZG^UW3Yj=W^"
    "U_g;iMW^U`I^]][^Ul5OUIk^UoPFB9W^V21MR]G^V4cR6J_^V5fC>BS^V7][V]C^V90DfE;^"
    "V9CK=V3^V=2EVEO^VEQ^iQo[VHiN^9W^VIl8RAO^VJ:=jN[^VX?jBE_^Vp0Z=ZS^V`UK66K^"
    "VejLnRW^VlNI:]?^VlSdnQC^Vm7L^^S^W0DTj2S^W:1ZJ5k^WF_b62S^WMjMRJ[^WPXK:Ao^"
    "WQ>]VIG^WSMi]V3^WcU?RJ_^Wjln:pk^Wo>`2MS^X<P<Qic^X>WP2R[^XCPibMS^XKS`BUC^"
    "XRhJ2Zg^XXpkB:W^XZL^^MK^XbQFIY[^Xm]`6AK^Y8N;J=G^YE7e2QK^YHnkiZ7^Y[d?QESV"
    "Z51SnV[^ZB^6Ij7^ZLkD>BW^ZXED=^3^ZYaP^YG^ZYe7::_^ZZmY:V[^Z_adN=K^Zmo=Z=O^"
    "[0AYeNK^[71DB6[^[:`ZREK^[C_Kn23^[GhRfFS^[KOS6b_^[[=;R5K^[iCUYnS^[jcZVJS^"
    "[lTc:MS^pFWeBEG^pO[pE]c^pP49j=?^pPn1V:_^pR<cRQO^pd:aARK^]0hhj2G^]4X?:V_^"
    "]8K@F5[^]<<0B6S^]>C[6F_^]?<Z^:W^]AQiBB[^]LY_>IO^]d_ZbVc^]nL1FEK^^4EDBRS^"
    "^5e7:E7^^9k=^Jg^^Am1U^C^^OAFMmk^^SJlZ=[^^V;PJ>S^^h7HQ^O^^l6cnMG^_4eP=^?^"
    "_72kNZW^_86]ZMO^_?4^BYG^_ES3B5K^_G94N=K^_L2N>Jc^_M2GFR[^_R9_fEC^_T<nY]_^"
    "_[InJY?^_`6RanW^_eC;6IS^_mY=mMk^`4JMN>W^`5Lb>fk^`=jdfRW^`>VIa^[^`KDQN6G^"
    "`RjDMVO^`Un]ijS^`c8iRUK^`hG6jB_^`l4HR9g^`m6ZB:S^a1cKNBS^a5eL>6_^a:0M>2[^"
    "a<U8f9?^a=S8EmW^aB_?:N_^a[=_N^g^a^lg:9k^acO=V=[^agmK:g3^b0;a=NCYb8_nYRK^"
    "b?Rh]aW^bCkORF_^bIBfjZ[^bPNpEnK^bUV@5B3PbcmmF>S^blL;]ac^boYCiVK^c5:>=j?^"
    "c<jBf>[^cAhEi^7^cEhK1]g^cI@:f1[^cJF?]Uo^cMlIZa3^cXU^B6_^cXkAmU[^c_H0bZk^"
    "ch6b^FS^d0W>F>3^d0iN5Mo^d;cOfR[^dH`dIbC^dJ3MYZ3^dN5NI^;^dNA9Z6W^dSdofUC^"
    "dX<5^UG^dZoAEZ?^deTcQbK^diC36>[^e0cJBB_^e1XE1eO^e<fhYag^e=Vmb:c^e>F[V2_^"
    "e?3UZIG^eFMS1ZK^eMA;ZYG^eOMJ5VG^eSGPFMK^e[30^];^ep4RINSpepVhEU[^e]_jjZ_^"
    "eaVPEUC^f3Sa:Fc^f6BX61S^f793FVg^f96P=V;^f<4mJZO^f=42JV[^f?TOf9K^f@Ahf6G^"
    "fB8jV5S^fD2]JV[^fUSk]]g^fZ[D>>[^fpVi5nO^f^a_f>c^fc>IJ>g^fkOgRBO^flNKbUG^"
    "g<GfJe;^gCPh:^_^gGi:bIK^gIQD>JS^gV:mfBS^g`891Z3^gaejZ^G^go[[>N_^hC>66V[^"
    "hUI^9iS^hXkD]fO^hZ`CjF?^h^6Qen[^haZMfIG^hc_CfEG^hd6eVVW^hgNKUf7^hjdYRB[^"
    "i0NoR5g^i?5[YbO^iD9CJ6W^iI>Dbbk^iKccEb?^iVUnVM?^iZAoJZc^ioo71UO^j189VZ_^"
    "j6dcjZ[^j<ha5]c^j=[bYmk^jVcNjEC^jWJl6fk^jZ1?BIG^ja7B]f7^ja<4BN_^jfTm:jo^"
    "kDE4=ag^kINI:BW^kPn`FNK^kR=RFUK^kVi6fVO^kZdV6A;^ki`bjV[^l::8FBG^l<l]mf?^"
    "lFh?mmo^lJZhVNW^lVAGe^O^lW_mfBG^l]?HNJg^l`DOB5_^ldN5Mn3^lj61M^3^m77RV5S^"
    "m<K^eJ?^m>APn^c^m?ZW^9W^mCI_Mfg^mPSaiY_^mZN6]Q_^mc<hY]g^mcOUZ]C^mgCDBES^"
    "mjfn>IG^n3U`:5S^n6FCjbo^n<kdm][^nfFPZM;^njGO2AS^o1G0:1S^o8R`M^W^o=7QF:G^"
    "oI0OJQK^oIYS2^_^oK_ZNIK^opTnfIO^ocAhF6O^od?NbUC^oe;iaeW^olXJ29G^00001ZC^"
    "02KbRQO^02[N6A[^0RIeEUg^0heY>YG^1<p::]?^1BAhR1S^1BTQ6NG^1N1[b>W^1i]X]Yo^"
    "23?LVYK^2@?gjYK^2AOajno^2GbVbV[^2Nfe21O^2Ue=BRS^2UlIVAO^2YPDamC^2dBJ^VW^"
    "35mU2:c^37fGaM_^3;58bRc^3@UIRbk^3@^_aiO^3B[p]j?^3DG5>]C^3F8_F=O^3NHDVZ_^"
    "3Z0a6EK^3akR:R[^3g^LfMO^3jFIbQK^4CH>]n_^4F?N6^c^4ZCc2BW^4p0Sba;^52K_jIS^"
    "5;?5nJ[^5Kgo=Y_^5XlCUbK^5^KK]jO^5b9P6EO^5iTDbEC^5mGFMZ?^65Ep25O^67DJ:RS^"
    "6Q8NjV[^6QH]NV[^6REefEC^6cCO2J[^6gHi>J[^6kcL]n7^7LINBEg^7S3Z5Ag^7TEIbVW^"
    "7[6YEIkX7hTTNV[^86h`2m3^886c5UWp8>FZR^k^8?Alj=k^8GRVRUO^8P:@JB[^8k4H5V?^"
    "8k`]9]W^92HSJfg^98=>jbc^9:6G2Z[^9o37:aC^9oD2j]?^:6=ERV[^:9cTnV_^:<=efYK^"
    ":<AB]aS^:>O9N1k^:FKiZR[^:MKfZIK^:TnDbEW^;1GX5jS^;>4=mNC[;B:DBUK^;M;MNQ;^"
    ";O=XAYg^;[nBbZ[^;aJX:23^<38SfYC^<IJ4:RS^<R`4jQO^<TC6bA[^<TgA^IW^<XX1Z:W^"
    "<c61N^c^<m@K6bg^=7IYMYc^=>:Ink3^=L4FnUK^=SQPnZc^=WSpZVW^=YZ3BQS^=YjAfIS^"
    ">1e5QR?^>OnKbRW^>k^E9J;[?A1;AfW^?E]>>QK^?Fh>ja?^?UW[^VW^?`k2^Z[^@8kGJVW^"
    "@9mdQQk^@BQ`fUO^@G3U2Z_^@MYNjQS^@^gf6]G^@eX;2QO^@gF4=Qc^@lLeYag^@m`8BJW^"
    "@mm;^RW^A3Thn6W^A418nAK^A7BO^QK^A?N::BS^AF[onfg^A^FZ6UO^A_[4ZZ[^AkS5fZ[^"
    "B3cK>VW^B5kC>IS^B8aUZZ_^B:iK>R[^BKpoBUK^BL5E:QO^B^SBUJG[B^klZF[^BdOg:EO^"
    "C;ZI^a?^CGQ4AbC^CYTHNR[^CeXG2Z[^ChYURYK^CkWUf=K^Ck]dV>[^D1eAVQK^DFlVRNW^"
    "DVp>V2K^Dc0GnRW^Dj4V:e7^Dm6mM^W^E?NcjZ[^Ec<mNZ[^EdoaiaS^EeY:jNg^F6hfJ9W^"
    "F;=a=NG^FFc]jVW^FHaE>VW^FPE5]^C^FRBI:J[^FRH1UV3^Fa@iEYk^Fc?H>IO^FeJOS@c^"
    "FeiN>AK^GG<GnVc^GMbgaQS^GlT[:FS^H57`Ffg^H6Ap^]C^HF6k]Y[^HORBB5g^HYCEnJg^"
    "Hb`BjQO^I87IfUK^IBJ`j9_^ICJoZIS^IY>@Ja?^Ipg>nAO^I^>VBFO^J2M`n>O^JDHmBFW^"
    "JHi6V9K^JHm:B5O^JNM=>QO^JRKNZZ[^JS7=UIg^JXX7nB_^J^1h:jk^JdD]6VW^JeF?UfC^"
    "JejJRNg^JhYRnIK^Ji@W:Z_^Jmd9M^7^K0=d1^G^K>ZiN>S^KRVZbV[^KXU[Va?^K]7Ob^c^"
    "Kmmd1I[^Kok5Z]C^L1SH9^?^L5hiV]C^L=InmV;^LFL5ffk^LI:o5IkZLO1TJV[^L]79>UK^"
    "M8RZ2QK^MELLne3^MJ2?FZo^MY`Qb5_^N1?7Ne7^N4@<fMS^N91eMYo^N;6Y^R_^N>8kRUO^"
    "N?116:_^NImjVQO^NQ@@=N[]N]:`a=c^N_LNmbO^O56?VEG^ONRNiU_[ONk8Z]C^OZ40f>W^"
    "OafXbB_^OdnmQZG^OhAW6YC^OhGGnAS^OiGQEVC^OoU`EMc[P>>=Z1k^PD4`VV[^PJlEF2S^"
    "PSJfFY?^PXA6jRS^PZh`bV[^Pm8bnV[^Q9=KjY?^Q;3pYZK^Q=XX:V_^QAnh2MO^QO6<2R[^"
    "QRIcnJc^Q^=V>Z[^QhKlEJ3^Qi3JZZ[^R=2n5bS^RFnj]mO^RG^I69O^RO<oam_^RVE[BV[^"
    "RX_l6UO^RfH]nVc^Rg?62JW^RimljIO^RneYNUK^S1PK6]7^S7X82o7^S8[fij_^SC<K]Z3^"
    "SFjYY^;^SNmZ>IO^SfnpfF[^Si]SbU?^Sj7lVR_^T;=gRFW^TGko=j;^TJYhAYo^TKD1jAO^"
    "TRScbES^T]lk1YS^Tcbo6FS^Tl036AK^UW3Yj9c^UZpPBfg^V8]JIUW^VC`0bQO^VIO_BZ_^"
    "VIl8REW^VOIR=]k^VU]>2]?^V`UK6:O^Vo9MFQ;^W3cK^^c^W52hNaC^W:1ZJ9[^W<aaiQW^"
    "W@dj2UO^WEEZbJW^WF_b66W^WSMi]V3^W`L;]M_ZW`LK6UO^W`^[6IO^WcJE>YG^WfE<jR?^"
    "XCPibQ[^XF:<VIS^XW43AQc^XWW`NMO^XZ26ZMS^Y13obIO^Y1OCnFW^Y6Oe>RW^YCh:QZC^"
    "YU:[VV[^Y]5gN9O^Y_g2bFW^Yf1OB5K^YiAg6=k^ZB^6IfG^ZO^RVB[^Zd<YQiC^[2ZBVMC^"
    "[71DAjS^[C3h:=K^[C_Kmn3^[UW8bN[^[V<KZQO^[ejYZ=O^[i]Gb^g^[mHOB=G^p=p;:UK^"
    "p@_;JMO^pAF0nUG^pBB@BJS^pNCQEE_YpPn1V6S^pURd2QS^pVm[NF[^pjAQ:Zc^]1gc9ZG^"
    "]4i:^V_^]5cpZR[^]CEE^AK^]FVpN]?^]LEn2YG^]fi8^Z[^]o91ZFW^^DiT>UO^^I;U:AS^"
    "^OAFMmo^^SJlZ=[^^VJ4jUG^^WGd>NW^^W_gMVKp^nj7iV;^_4eP=VC^_7cCRV[^_?aNREO^"
    "_H7df1O^_L2N>V_^_MSZBVW^_djIR>S^_fE`FUK^_lMg^VW^`5bGVMO^`O>ViYW^`RcbnUK^"
    "`UfM:o7^`]T@bZS^`_KL]^S^`l4HR9c^`oi;ZYG^a1cKNFW^a8HQj9S^a?hbBRW^aB_?:Rc^"
    "aJ@TR=_^aR>e2NW^aRQ0je7^aRalZe3^aT_E:RW^a^lg:9k^bPNpF2W^bPcabRc^bVhdbQS^"
    "bjoCNUK^c17@^QK^c2>l>=[^c8ZnBV_^c9[hRZ[^cE;YBMO^cHRWRQO^cR39=MS^cajZnRW^"
    "ch6b^JS^d0W>F:3^d57afUK^d6:4fRO^d>EA6MO^dH51i^W^dJ3MYZ7^dJOjEQ[YdNA9Z6[^"
    "dSeGVbc^dWoiN9S^dZoAEZ?^d^KkRNW^d^XnnRW^doR@^YG^e<fhYUo^e>F[V2c^eFMS1^G^"
    "ep8526S^eanS>a?^efTEZW7^f1acjJc^fFD7B]?^fLg@^2[^fMa=^a?^fd1QaJ;XgBLceZ3^"
    "gDHlJbk^gQXEfIC^gRfRAJK^gcDA>YK^gh]XJQK^gjQNbbg^h;Z7NUO^hE9mBbg^hZ`CjF?^"
    "hZ`IJa;^hcpkZVW^hd6eVR[^hd]ejVW^hgNKU]o^hj9i^k7^iKccEZC^iZ:^NR[^j;m]6UG^"
    "j=[bYmk^jB1<AFG^ja7B]bC^jgCf:RW^jjB?=Mk]k7WibUK^kPZo=jW^kT:>Bfg^kU=m=j[^"
    "l::8FFK^l:e9>R[^lFh?mn7^lPJV2F[^lW_mfBK^l`DOB5_^lbl]Zbc^ldN5N1k^m9_<faC^"
    "mFZg>bg^mHR9FEO^mI74VRk^mM5OQZO^mc<hY]c^n^MERV_^o2?DBUG^o4><b:S^o9l@ibO^"
    "o=7QF:G^oBNH:MO^oBf]nQO^oFPSfMS^oIX6bRW^oK[SVE?^oPEQnR[^oXUZ6k3^ocAhF6O^"
    "00001n3P0]D99Qg^0`22BB_^0n;g1R7^13jiiEoZ15EY=R3^1CNP9ak^1P3NEmc^24l?MN;^"
    "26Fnaf;^2VcfeR7^2YQ_nBS^35mU1nC^3B[p]f3P3Ppn=V3^3hf3^?C^49]aQ^K^4?LdMF3["
    "4@gS]Qo^4b_;5j7^59DGe]o^5@N:1R;^5bEaFR_^6D>FQ>G^6KH8]Qk^6p>h]b;^7Jn^mIk^"
    "7LINA]g^7O7GF5k^7lfFEU[^8L04Q]o^8X^<=j3P9>hS9jS^9O`A1Qo^9UOCmMk^9Vj3=Yc^"
    "9e2j9ag^:OFgER;^:VPYQYc^:WkHb5S^;8H@e^?^;bJQB=W^<2AH=V?^<F_i2>[^<QK6N1g^"
    "<[B;Qb;^<a1>MMk^<bKm]Uk^=Zhaf:S^=[j>n=O^=b2T1Yk^=gViMn3P>Tk2YYo^>XZHjEo^"
    ">eb`QJ;^>k>R^=[^>llR]R3^?;5IYj3^?gnpZ9k^?lS8mR?^?mmhAfC^@NJ`EU[^@R:6VF7^"
    "@d^@J9S^@mTNQn;^A:BV=b3PAHCg]Uo^A`Lm>2O^AaNJFEk^B1D[1ZK^B42T:AS^B73]mAkW"
    "B8NM=Qo^BXGkj:k^C0b^69c^C0kAEZ7^C853QR;^CYlZf2C^CZn7n=k^CmRAb9_^DSeb=^7^"
    "DjBK^Ag^E<fUR1W^EBUXMIk^ED0Ga]g^EdM?eQg^F9V_N9g^FCVn1]k^FPE5]b3PFcb9J=g^"
    "G6FC>=_^G6OLYfS^GGG:QRK^GM6=MF;WGNPl]Uo^GZ[Zn:S^GpYcYak^Gm?db6O^H36M:I_^"
    "HN7S1U_^HORBAmg^Hion^>c^Hoo:Eb?^IBJ`j5_^IihA]Z3^IlV:f=[^JRi51b;^JXX7mIk]"
    "JZ2g=Uo^JcOpJ:K^K63f>6W^K;jNVQK^KRO[En;^KYYMQV3^K_=bmn3PL2d0:B_^LEH9nBc^"
    "L]IZ1JK^LdSL=R7^M5J<>9_^Md:2MIo^MeTaaf?^MlC]f2G^N>ggZJW^NF1YeaS^Ne;H1f3^"
    "O1iO]f3PO;X1V>_^OX3fYjK^OhkTQ^G^OnZWMEcZP05F]Qo^P>>=Z9S^PhR:eYo^Po[m1Qo^"
    "Q57_>>W^QQSTEn7^RDL2nB[^RKL[]f;^S4MO25_^S:<QmMg^S;WAA]c^Sp49EQc^T;=gQYg^"
    "T=k`ZN[^TGko=V3PTn6F9bG^U>n41VO^UD]6mF3YUF7f=Yk^UT@]9^3^VE^LQYc^VG9;aio^"
    "VgV3eV?^WF_b66W^WSMi]j3PWaO;=]k^XJOnQ^C^XP?1MF7[XQY`]Ug^Y3QH65k^YJ6Tej;^"
    "YQ@G1V3^YVdpMn3PZU0SQFK^Zp:E]R7^Zm15]mg^[MDdF5W^[[`kmEk^[];[Ab;^p=XSE]c^"
    "ppbAQb7^piPI=j3P]FdR29S^]OZ`9jK^]`RN1ZK^]fAPmAcY]gp@=Mg^^5e7:5_^^CT[n=o^"
    "^`94EYo^^gBfQQg^_@D?Z5[^_I:Mej7^`=4IVMo^`C3U=^;^`OXSJ9S^`l4HQj3^a1cKMQ_^"
    "a3>:aYk^a3mk::c^a^lg:>7^b2da1Yc^b5RZ:2C^b6T7BB3^b?Rh]V3PbI8A69_^be]?YZ3^"
    "c6TmQRC^c<D0IEoYc=^_]Uk^cEhK2Io^cKgVYb7^cXLTfIS^d<alV>k^d=EF1Qg^d>`5Af7^"
    "dU<^b=_^d_<mEQo^e>F[V:[^e?H8^Eg^eK4c=b3PeQlBR9[^eY64]]k^fB6h1^G^fGejmIgp"
    "fHed6:W^fI@Z=Uo^fNpLNIg^fk8AUj7^gA]NEb7^gEUn2>g^gHg@QZ3^gNKUmn3Pg^0`>=_^"
    "hH<:6=[^hLWM1JC^hSa?=N3^hZ`Cj=c^hdWo=j;^i?5[Z6[^iQYeR:S^iSGeMI_^iTbTa]o^"
    "iWPMfMW^j5?Lef7^jNIoN>c^jTI;1]o^j`n9BFW^jo8T=VC]kGAYYnS^kQ0;R=W^kX9GQVC^"
    "k]hJMJ7]k_C9]U_^kmL0Yik^lGi]62?^lW_meV7^lZMfjBW^l^i`1Uc^l`DOB5S^m@aGEeo^"
    "mW>0f:c^n:ZN]^3^nYd<nA[^nc[B1eo^niJDmMg^nje4=]g^oP]^R6S^ocAhF6W^ojKZQYg^"
    "00001Z;^0593en?^0:l;34o^0Ab3nno^0^`@^6[^0nRUV9K^1pj_N5o^24W0B0_^2TJbf^_^"
    "2_AM>>G^3B[p]j;^3LEQemc^3`AR>9_^49h3K77^4?>0NAO^5j81ZA[^64b`>J_^6Cg96i;^"
    "6LT=e:GQ6_1>V9S^6kcL]mk^70Qepn3P77MSZQK^7<:p2CK^7Qi]>=_^7ee]V2G^8?l>Nfg^"
    "8FJ2ibc^8pPU38k^90fKVJ_^99BQQno^9OI3[8k^9P6oVIG^9jS969o^;1GX66K^;^Kp^V_^"
    "<QI96i;^=CQCj8c^=D<Z2F[^=Ld0^j3^=bp3>ec^>^Xm[>G^?17INN[^?;_[?77^?@UXV9O^"
    "?]_66;C^?_9j_33^?eK[>no^@3N7>MW^A6>:EIC^A?1U6YS^ADjgnjk^AfjBf3?^Ahd?KCC^"
    "Ai6XmAG^BH37B0c^BXcF1A7^BZ?9N:?^C=YHmio^D@06b>C^DONEiek^DcJF>1_^EIPV^UC^"
    "E]LW6:C^Ee5]j8g^Eljf>2G^FPE5]io^G?98MM?^GR[cNB[^Gb:2VEO^H?CP6GC^HU2Q>EW^"
    "HWNABaC^JJ[2mLg^JQ96Qlk^K;cSR6C^KZZNAB_^K_=bmf7^L>5nFm7^L]2LZm7^Lh^BnF[^"
    "MKnLb0g^ML8RN1k^N3_0nV[^N?116FW^NFZ7j<g^NNO@>2_^O1iO]jC^O;SDf=_^OnKcN9[^"
    "P4@=NF[^Q92[C<g^Qkk9kH[^R`:CV5g^SdQ_^>_^TGko=nG^U6`1mY3^U7odBaC^UmplN5k^"
    "VLYJ^=k^V`UK66[^W03Z=fO^W;;3kKK^WMYO^FW^WSMi]Z7^W]7^f9S^W^gpmM?^X:A<FFW^"
    "XP0=R=W^Z`E<N:O^ZdU=R8c^ZocKUmW^[C_KnAW^[[Me6m7^[b[j>EW^pF69^>[^p]cBESC^"
    "piPI=jG^]A>bJm7^]f2pnIG^]kg6n:S^^ILlN6C^^OAFN1k^^lg;mek^`>p8jAW^`?m>:??^"
    "`ZhOZQc^`[eVFJ_^a1TWRA[^b?Rh]j7^bTQFbRS^c=3Y6jk^cAiVNZk^cLQh?33^cQGeV1k^"
    "ceCen1k^dD@D>=g^dfo=V=c^dgZS^J_^eE@I>R[^eK4c=j7^ehPS34o^f[S7FBG^fk1FN2K^"
    "gNKUmj?^gfOJNno^hL@?W4o^hPbCb>G^hYU=Vi;^hbTG_??^hgJE65o^in>d62C^j=]3>6;^"
    "jXV9j7G^ja7B]mg^kXdZ:Fg^k^X36no^kcN0NBK^kn6B?77^l2l?Uag^lA3en>S^lFh?n1W^"
    "lQPQ_;;^ldN5N2;^m5pB]lk^mHSWVAW^nJ?2]mc^o=7QF:O^oLU`QjK^okL[AFo^00001eo^"
    "00Y:i:GR0WVm6io^0ZS6bAK^1W<AG8k^1l@A>]G^2<TS1Ng^2^^>:A[^3B[p_:O^40<kbNo^"
    "498pbK3^4CH>^1O^4Q<B1nS^5APY:a;^6LKeNG7^7?HEbno^83oTb53^8I:9Bjo^8TZQo;;^"
    "8cepZYO^8df7bVW^94RH:Ig^9JaJZRc^9h23N9c^:O1D1j[^:TjIBbg^:`5[>J_^;1GX66O^"
    ";@BX:MO^<0PbemS^<i3fV53^<jJC:Rc^<lb^5ho^=4]1n=W^=O0IR;7^=QL=6=k^=_S[g;;^"
    "=boYAnS^>?pOEmk^@K?^^^g^@V<g^0k^@]B_6Bk^A55_FVk^A6>knjk^ABQdnjk^AOS9^6S^"
    "AcC5:U?^Ai6Xma_^B8ZYf=W^B@_]iB[^BVon^o7^C9ghZ1[^CJUY>6[^E0lTeS3^E6bWJeO^"
    "E9RdF:g^EaMCFCK^EnE=R73^F4DiR:[^F`Tm^bg^FcB2B5G^GIKW:J_^G^?Nn1W^G^hYe:GT"
    "H;R^^AW^HB0mB:g^I7;DbFg^IegMZMC^JZ?3fA[^K0k;[:G^K;@DN=_^K_=boGG^L1W]YmK^"
    "L^BAEPk^M<YHJE_^MahDZaC^MiVm>>c^MjGRjm7^O2jmXj3PO8M8:IW^OE;=N:_^OJ^h]AW^"
    "Q3BSZ6C^Q5Gfk5c^Q@J`n7;^QhKlG;;^R=BeRYK^RDT9]m7^Spd^NIO^S^`AbQ?^SaDff2o^"
    "TLF>aMC^UFlIJFS^UdL];13^WSMi]j7^X0<m:A[^X@iXZm7^XQVD:mo^YWF7j=K^[0N_>6?^"
    "[<h3F1O^[D5?ae7^[PeknBc^[g7_N2O^p>UXV2?^]`a[Z^c^^a]d2Z_^_9cL?:_^_P[^Z2g^"
    "_ib=ZI?^`HD1RF[^`VLaEQ7^`aQh:9c^alQ=b=o^b9bTR2K^bCSTnG?^bVK;:F_^bhJ:k4o^"
    "c6a:6<k^cMMAkKK^cR39>67^cZ<JZm?^cfBRalo^dKbAOCC^dLQ`B0g^dY1]V]S^e9<D1ig^"
    "e>S?9IC^eUkGJEc^eXW1g4o^fFiY:e?^fX>Wj^_^f]VlVBk^gR_>>;;^iV[KBno^iZ7Hb2c^"
    "ib[1bA;^j6d>f6G^jJK:en3^jOEUQ=[WjbOE:aC^k1:oFRk^k<9=Eeg^k>CbR5K^khGM:IG^"
    "l:U]b=7^le@M:YC^lfi6NVS^lmF[O33^mB]5iOC^mHS8NR?^mXmF^V[^nA=7a^_^nhB:JJO^"
    "o52SFIC^oA]HZ1S^op0`>33^oaWLJ>S^00001jG^0S^0FIG^0V59:6C^0XE@R=W^0cDR6AK^"
    "0hQ9NJk^0oMmNG?^13SAN=C^15pk6BW^1<`aIiS^1>Jej9O^1HmWae_^1MBW:1c^1N?d1NG^"
    "1N[PIbW^1QnXn>S^1Tg31Uc^1W@n>YG^1]Fbj2G^1fA<MV;^1g?L2F_^1nCBEQk^2>e8:5c^"
    "2A4Ii]G^2CQ9inS^2CcJZJk^2DY=fUG^2NiCj2K^2P?AUn7^2Wc]MV;^2dEFEbC^2l4EfA[^"
    "2lGL>9K^2m]Ij9k^2ncFVRg^31DeiJK^353ZenO^35_Oae[^3;QNAj?^3AabQf7^3MmNV1[^"
    "3TCTf>W^3XoVZIW^3]im>I?^3_?jjU;^3cg;6Q?^3k=KnNc^42KemaW^4:nQJJ[^4GJHAek^"
    "4OLN9aS^4PbKf=g^4UIp2EO^4W`db2;^4XdQ^1_^4]_`j^k^4j<e6Jc^519Y9nk^58li>9O^"
    "5APOG;?^5PG<66_^5hk7^F[^5jOJ9f?^6@Pcb5g^6D52f1O^6EK0R9K^6EO6FB_^6Id5b:O^"
    "6PToR2G^6Qjm=b?^6YBjFFS^6n37j9K^6oI5VMG^70O2BN_^75WSbIC^76_FR2O^76mQN=K^"
    "7CMN9b7^7G6VIMoZ7OY:=f_^7_UXf9W^7`kVRE_^7eRf^EG^7li7ZB[^8PZOaeO^8RIEj6_^"
    "8Xg9BYC^8YLPN2W^8_KLR^_^8khPb>W^90QVm^G^9R2g^B_^9_7M^]G^9b47mbG^9jVcFJc^"
    ":3D^>=W^:7XIFG7^:G6p:QC^:G:b26W^:HAR6bo^:SVXifC^:_ZWbU;^:o^cV5K^;14a>9G^"
    ";2:]nNg^;8K2:2G^;E99ef7^;QDeinW^;pFmnIK^;g>RJ=G^;nTcF>K^;o?SRFW^;o@XAmk^"
    "<=eC:IG^<Xa3FI_^=ZhafJc^=lBO2Vc^>B_E1V[^>JJ`5ak^>SlFf6K^>[BMn>7^>e0U2GG^"
    ">iHIEa_^?2`LjIC^?3fIVB[^?5Jp21c^?>]n2BK^?FBIj:[^@T<JbJ3^@U`]>>K^@ZL^nQW^"
    "@o8V2m7^A9Hp22C^AVfdFIG^A^hjB9O^AeKOAb3^Amn:^c7^BHIEFM?^BPKK>1[^Bpn9ZFk^"
    "BaeTYf?^BigZQi_^BjH@6R_^C4L8VIG^C5R5B:O^C6d:>6S^C9kfB9O^CAml:EC^CGn5V2_^"
    "CSH5Ub;^C[J;M][^CkNG>5o^D3PM5j7^DDjVQic^DLlpIi[^DT6RR]G^DVp>VBS^D^>;RY?^"
    "D`8WN:K^DnF@26S^DnTJnAK^E6M7MN3^E7ZJf1?^EP7YEMoYEXRP2=G^E`6kj5W^E`TUj5W^"
    "Eh91bAO^EnSiZ0k^EoYfFRg^F8Ga:A;^F:QJbFK^FAUA69O^FR76f5_^FS4C]RK^FY[R]aS^"
    "F^YeBNk^Fi67Q_?^Fk5p9RG^G37b1Q_^G67d>IG^G7=`j:_^GCYWb5_^GHEYUnO^GHWjFFc^"
    "GIYa>Bk^GS]cV6O^GpX=9]o^H1;kj=S^H1o4FBS^H9h:QfO^HE@DQb?^HNXH5ik^HORBB9_^"
    "HUb>>]C^HadC::S^Hb^LjIC^HcD1bm3^Hd4JRIC^HkJ[Mj;^I01kZFW^I88c9Z;^IBJ`j9c^"
    "IL>gmeg^IT@mf9K^IUVkRES^IZ>;^EO^I]Y1J5_^J1ER2N_^J5n8f2c^J=aHj5_^JEcNb5_^"
    "JSbbR9c^J`EPnBk^JgPYbNo^Jm_WJFO^JoCief;^K7cOj=G^K8iLV2c^KJ?P=i[^KJCV2Bc^"
    "KKELjW3^KNXUNBS^KUIO>:G^KbcKfI7^KiF0f9k^L2gWVAG^L5CQn>O^L:L3NI?^L;Sf>6O^"
    "L;b1:MC^L;kcNa7^L<@NbF_^LFl09bO^LHAmej?^LcOnf2C^LdJ8R9S^Le`6>EG^LknTIiS^"
    "Lm6G9^K^M1]WF>?^M8l1AQ_^M9dNab;^MUNoN5O^M[igFEK^M][XnAC^MgZ6fg3^N31=ZF[^"
    "N5F6YUk^N7YdMng^NEM=nB[^Nb1<V2_^Nc`fRAo^NfhWUfG^Ni<EN[7^NoKC2FK^O9O;R=O^"
    "OKk;f5O^OKoAZ>[^OM18RRo^OQ96>=g^ORbIV6c^OXK8UfG^P4SCB9O^P6o=VBW^P8SP65c^"
    "P>>=Z5c^PHW[ebS^PImYQf;^PJf4ejo^PJlEF:G^PZk`:Z[^PgKajAc^Pnb2e^S^Q;P:Mj;^"
    "QGbo=nc^QQMONJ[^QiEbNo3^R9EP:>_^RG8iZ>c^ROP9N:o^RcphAao^S;:g>5S^SNpd>B_^"
    "SQolb:W^SgB6N6k^Sl]H:Ec^SofBYa;^T6>nj5S^T8ZiB>S^TJCGQn[^TNJLnbg^TW]D6I_^"
    "Ti7MRAO^U0M^M^S^U=;f9b3^V81Y2B_^VHdUBFo^VL7]fBG^V[[D2EG^V`UK6>K^Vo_pY^7^"
    "W2bZFJW^W:1ZJAc^WF_b66S^WM=e2po^WSMi]bC^WU?jj1W^Whmb:?3^WnI3fEK^Wnp:=e_^"
    "X:FTn:S^X>`EnAO^XFbKfEG^XKo3:Jg^XX<UAb;^XYHobQC^X`>[9mK^Xd4Cn;7^XdWb>R_^"
    "Y0Bfj9[^Y29J9f[^Y8Dlaag^Y:2@E:;^Y>gQab3^YI_6=io^YQa<5]c^Z3HjZAK^Z9]D^N_^"
    "Z;AW9Yk^ZJP@nVo^ZpeZ2fg^Z]Fo^AG^Zd]@Z6O^ZdkKVAO^ZfK;W0o^Zj0EaaC^ZkkZUac^"
    "ZlmQN9W^[1KHAbC^[4NF2J[^[5::m]S^[?EjNJG^[J=i_33^[NiPZEK^[SP`fEO^[ScKBe;^"
    "[^P2J=C^[iR:NEO^[jYMb?7^p7lA]U_^p<2@V:[^pMZ^fNg^pQaIN6S^pXRCB6K^paLpeb3^"
    "pk8g:5[^]3e5b2c^]60KV1c^]>pZ=jK^]@S=Mb;^]J4d=f;^]KJaij3^]Ro=aN;^]gRlR1O^"
    "]h8QNi3^]hhj>MC^^0?;9bC^^4fKFBS^^5e7:9W^^68?JQ3^^;I0FFW^^<mBe^7^^AT`bE;^"
    "^L;lZ:_^^OAFMmo^^Q3GYm_^^Y5MRIC^^ZKK>MO^^_2[J=K^^bMQ65_^^fHlB>[^_373mnS^"
    "_6:1^J[^_BUhUmg^_JWnN5S^_Kml:=c^_k=f:EC^_lE9NO7^`2T76>G^`48IQi[^`6LXVBW^"
    "`OFJN>W^`[SlUb?^`kjI5nW^`l4HR63^a5PaN:[^a;pD61o^a?@S:AC^a@VPf=G^aB>i5f;^"
    "aGlab6?^aK`Of2G^aTZiIV;^aUe;nJW^a^lg:>;^ai>X>5O^ajTUjMC^b0c469G^b1jfenG^"
    "b=4p2FW^b>XnMak^bC=KZR[^bZCO:5[^b`^G2AO^bh4WnFc^c4b_Z:[^c<ND:O3^cKf05^K^"
    "cZBmf5c^ck]7AbK^dQ26::O^dRZX:^c^dU8`b>[^dZBn2]?^d]?XAjK^d]o[b=k^dcN6N67^"
    "e1XSjAc^e7<M62S^e8do62c^e9Gbj9O^e=Gob5k^e>F[VFO^eCjTab7^eF[A^:O^eIXMI]g^"
    "eK4c>2;^eNb9=b7^eVFU5^C^eVd?61o^eZf8:EK^eb<I2>[^ejjCj=W^el@AVMC^f3VRN2O^"
    "f>`G^J_^f?L<YU[^f@DZ9b3^fi`CZ:_^g6NKB6K^g>9of>g^hR]ab6O^hWlW>F_^h^kCijG^"
    "he9b66S^i8h8anS^i;3NUmS^iEV@Mao^iKD95ek^iO7g::K^iX2@]fW^ipQcbEG^ich4^>_^"
    "ig`VB:W^imkm>EK^j4@_F^_^j@L3FJc^jB0Eef3^jkKoAj[^k8:6mnG^k`Oc^EO^l0@i6I[^"
    "l4T<Eb7^l::8FJW^lFh?n5k^lR2D^MC^lTIMN6G^lZ4JV9O^l`DOAmo^lfeMb6c^m1gUfA;^"
    "m3PYie[^m:SdMnK^m?bYfN[^mCTeZEK^mGAl5ak^mKVkR9W^mLodab_^mPcRf:G^m]14mb3^"
    "m^=ONEK^me3:f5W^meS`JJ_^moWXjAO^n57FV=O^n=9LMeW^nB7_2Rg^nE]2Vfk^nNSUif7^"
    "nVU[aY[^nfYgR5k^njHZ>AK^nm7Zn>c^nn[mIn3^o35BBjk^o@66eac^oH8<^9[^oLAbj5W^"
    "oVS`ZIk^o`g2>UG^ob;OJEG^ocAhF:W^oi_kBMC^00001b7^08K8^E_^0FQ]9Bg^0O6>W77^"
    "0`aG6RS^1X0SJ2K^1`[3RQ?^28?3YmK^2>:jEjK^2LA=JA_^2SWWmnS^2c9Z:JK^2j9E6F[^"
    "35K7^N[^35mU2:;^3;]nnY_^3B[p]ik^3Q3>JZg^3e5=^A;^49Q8MbS^4@lej0c^4EBgJES^"
    "4Vjk6E_^4^_6]eg^4iO4jM?^561;ij3^5NpC2AS^5O=ibIK^5YIQb^c^5`SAUf;^5e^0:9[^"
    "5hZ95^3^5mAIB2G^62mFR>[^6P7Abjk^6SE:m^?^6XVNbI[^6]8`JF_^6eiDaag^7@l]:N_^"
    "7Ofp:IO^82C6EiS^8^F@J2?^8lLSNEk^90ZXV7?^9;aGjB[^9IPl^>g^9UVMb:S^9elafR_^"
    "9n]F9bO^:1>TNFW^:>O9N5k^:BS5^IS^:E?3F]3^:WkHb9o^:^[BZAC^:hpYVbk^;1GX66C^"
    ";>jLaeS^;Um0Qj;^;V<QmM7^<<7GMj3^<DUIFBW^<EiF>9[^<HeO9M_^<Qb`f5[^<RDn:Jg^"
    "<dm=aZC^<n`cBN_^=3GTf6G^=8adfA_^=Zhaf>S^=a83>NW^=gViMj;^>022>IC^>Y_Jj9o^"
    "?K?^9n;^?LWiR=c^?[8oRFc^@5acenG^@7TdZJ_^@A]lbNW^@DBlFB3^@K:KZdo^@QIjRFO^"
    "@]_;Z5k^@b^KbAS^@jPbjEO^@m21>BG^AFZkEaS^ASW@62K^Aemc2>_^B3lO>0c^B68FR2?^"
    "B6bo6JW^BCXp:Jc^BT;f69_^Bcm0nN_^Be?o>:S^Bi0e=]c^Bi[M^2_^CAJC>I[^CDXkim[^"
    "CXm:jI_^CYVhF=K^C`A2Uf7^D;i9Amg^DP=HBEO^DVp>VFS^DcJF>1_^E9j`nAg^E<fUQic^"
    "ES==YjW^ET;]FJ[^Ela2JF[^Elc?VAk^EmVkVA[^FI?2BE[^FUm9jBS^Fp@1:A_^FpbNNEW^"
    "FbJiamc^FcZSmj;^G1U@VFK^GpD19jc^GpF19mS^HORBB=K^HVCpUQC^IBJ`jIS^IF@2F9[^"
    "IFG^1ic^II<;ALg^IR9LnE?^IXZaFIG^I^2gW:K^IkUpB5K^IlNUIn7^J3^@mjO^J98PnEW^"
    "J@LHYag^JBl<^N_^JVlO2BS^K0H^FAS^K7pV1eo^K=6f2:W^KZ672=c^K_=bmik^LLnUZEo^"
    "L]Nl9ho^M5=S:>W^M5BVanK^M68OnFc^MGM1>@g^MK`>6Rk^M[Gj9n[^N<kBn:_^NgV4]bG^"
    "OeV[F>K^OfKHJ9S^P2Dc2AK^P@J52fG^PG;OFA_^PJlEFJ_^PYCg2AO^P`W^]j3^Q<?eIi[^"
    "Q>_YNc3^QE_DJBc^QPT4JAS^QUp4]mW^QWCnBUK^R:AM6A_^RTRIJJS^Rm9k^F;^SJd7:6_^"
    "SdJ96EO^T4oQ2V[^TNSEbF_^TTMMb:[^TZB;5]k^ThHN:NW^U8^_^J_^UAOD1Uo^USjjYnc^"
    "V;DkbEc^VFV^N5S^VI1@YaO^VMi5Z9O^V`UK6:[^Vm;mBB[^W9O=6EG^W:1ZJMO^W@aTBEO^"
    "W@c4aU;^WDf]1n?^WF_b5jW^WPGpB>[^WSMi]^7^WWC;:>O^WWGG>>_^WpK;N9S^X0_JN=O^"
    "X5gJb1W^X7ODFYO^X83B9e[^X=MR6>[^XARa:Nc^XJCEMRC^XZLc:AS^Y4]_NBS^YMEAb9o^"
    "YV]72I?^ZDUO:IS^ZPNUN4g^Z`;HZB_^ZmjmJBg^[JFbRNc^[S7FiWG^[gl`eR?^[iY421[^"
    "pO`GJEG^pfb4R9W^pi<V^1O^]70c6FO^]OT9F]C^]YZS:AO^]i0HZAG^^6^nfJc^^7NQ>BS^"
    "^IG>MfS^^J91f8g^^OAFN1k^^Pj`REG^^S:cnN[^^]Xh:6S^^^;ES6[^^ea8R=S^_5d86^_^"
    "_:X9>=O^_KmJV?;^_Ti5RBO^`0Q<>R[^`DS;V9W^`RHnFN_^`bV[6>S^`d`e>a;^`l4HR=O^"
    "a8SEF:k^a?S0BFg^aZDc9=_^a[neJJS^a^lg:=_^aoTLFYC^b6@mj5g^b:TmgGG^bH86iYo^"
    "c81@b7;^cKSd:9S^d9ei>EO^dAGF^33^dHG1ZFg^dWYgB:O^dedCnMW^e=d>=nO^e>F[VBc^"
    "e?@SAjC^eK4c=nC^eWM8EaC^eZcOB9W^f54KVRc^fPpRBR[^fQLgFFc^fcknFe?^fd^QZ9W^"
    "gDl;BMO^gQ;36F_^ghlH5bO^h5ZOa^3^hH4TYj7^hZSZfRg^heGD2AS^hgNKV>O^i1@^ZEc^"
    "i@^1f:_^iML9Mng^iX?bZE[^ig6UjC?^jja^^A?^k7e=FNc^kPhV62C^k]oTB:W^kcGpAjo^"
    "kgF=JJc^l4=Jn0k^l::8FR_^l:neF=W^lFh?n5S^lU?aZJW^lV@:j;?^l`DOAe[^m0ghF^o^"
    "m=][]b?^mDigZ9S^mW9k1f?^mbmG=nC^n7bFF9g^n>S`Ye[^nI7^9Z7^nUeeeYk^nYpWQnO^"
    "n]V52J_^no2S^AG^o=7QF6S^oERZ6=S^oFUgR97^oHNc1V3^oI^3VR_^oJcVQbG^oTCe2^_^"
    "oVS`ZEW^oaECZ>_^ocAhEjK^0002FXo^0005Aec^0006Bg;^0006E^?^0008M]g^0009>1k^"
    "0009MEg^000:n2_^000;UE[^000=2Nk^000?Nm3^000@>Zk^000@A^G^000A2EC^000AYN3^"
    "000C:E;^000D>U?^000DV6S^000G2Jo^000I=mc^000LJY7^000NR6S^000PB_7^000PE^?^"
    "000RMag^000R^lk^000SQMk^000Tn6[^000W6F_^000YR];^000Z>F[^000ZAbC^000[2AK^"
    "000[]V7^000pMf;^000]:E?^000^>EG^000^jc3^000a2Fg^000fJQC^000fNB_^000gN=?^"
    "000hjbk^000jB_7^000jEfC^000lMig^000l^lk^000mQYg^000nn2S^0010J=g^00116BW^"
    "0011bN_^0013RIK^0014>FK^0014EjG^00152=O^0015B^g^0015]Z7^0017JZg^0018>EK^"
    "0018eak^001;2F_^001;b1W^001<0moX001?Bc3^001@JIK^001@ZK7^001AN5K^001Bj^_^"
    "001DBVk^001DVXo^001F1:C^001F^Xo^001GQ]k^001HmnG^001IYaW^001Iji3^001J]Eo^"
    "001MRA_^001NEjG^001OFc3^001O]b7^001QJJ[^001R>9S^001Rieg^001SZA_^001SiFK^"
    "001V1JC^001YBW3^001ZZ>o^001[N1S^001^BNc^001^ZY7^001`1NK^001`^Q;^001aQec^"
    "001bR^g^001cjhk^001d[;G^001d]Ug^001gR=k^001iFRc^001kJBS^001l>9W^001limg^"
    "001mmFG^001oJMC^00201VC^0022n5_^0023=5k]0023BJ_^0024Z:g^0025Mm[^0027g37^"
    "0028ZIC^002:1ZK^002:bI?^002<R^o^002=j]3^002>ZgC^002>]]o^002CARS^002CFJc^"
    "002G:Po^002GmN?^002IJIG^002J5^G^002Jf6O^002M=M_^002MBFc^002NZ6[^002QfZk^"
    "002RZMG^002T1^O^002TbEG^002Tf6O^002V=f7^002VRW3^002WjQ7^002XZ[C^002X]ag^"
    "002]A^K^002]FBW^002^o7?^002`:??^002a:A7^002amV7^002d5fG^002g=Uc^002gFB[^"
    "002h^2O^002j:=S^002jI9k^002lZIK^002n1bO^002nbAO^002o33;^0030RVo^0031jI?^"
    "0032ZWC^0032n]7^0033Y23^00356pk^0037AbK^0037F>S^00386FW^0038no;^003;:=C^"
    "003;m^7^003>5jG^003>Flk^003AA]_^003AF>W^003B21c^003B?3;^003B^2K^003DIMk^"
    "003FZAO^003Fj;3^003H1jO^003I2g3^003JVNg^003KnAK^003LAJK^003LZS;^003M2U7^"
    "003MJIO^003MY9k^003O6Lo^003QAnG^003S2_7^003U>5O^003Umb;^003XF`k^003[Aac^"
    "003p?3;^003pEJG^003^IUk^003`n6k^003c2W3^003dVJ[^003en=S^003fAVO^003g2M?^"
    "003gYB3^003i6M3^003j:a?^003kAnO^003m2S3^003o>1[^00002:7^0;jUV23^0m6a>Mg^"
    "1@Y1V=o^1eN6NAg^2=F=EV7^2C9:V:G^2OO7Aj7^2[Ipeio^39M<Ej7^3>gnU^;^3B[p]Qkp"
    "3IYHN>3^3JbT=^7^3OIdIYW^3p7l1Uo^3hf3]f;^3i0o^Mo^4c><V>3^4f7`jJ3^59Z1BEk^"
    "5M<AZR3^5XlCUik^5`@h25k^6=PeI][^6HE:mio^6J>m623^6ZN4ij3^6fHZN63^6kcL]ZC^"
    "77^2Eek^7BZH:=o^7DL9nB7^7b1oJMo^7l[HnJ;^92[12Qo^99m<9nK^9Ega]]k^9F=AJN3^"
    "9ckA>27^:@JNB>;^:GIS1Z7^:K=A9J?[:SD8Ub;^:WkHaN3X:dYPMUk^;1GX5f;^;O=XB:3^"
    ";[2o:Ug^;nU?R5o^<hbLJ5k^<kp0^V;^=?>A6R3^=Dl9ab7^=F2IeUk^=Pf_If3^=R`QNN3^"
    "=boYAj;^=nj>in7^>4E19Z?^>@?V]^3^>Lm^In7^?H>WnEo^?T3nfIo^?gV?>9g^@BN`Uj?^"
    "@NIF9ao^@lLeYj7^A8?@fJ3^AG0]eJ?ZAKaQ>Io^AOk7Ib3^AS^eQJ;^A[e]1jC^A`Lm=Qg^"
    "Am;4eYg^B9i<Qf;^BT]YBFG^C@;jn:3^CKklj5c^D;DdAm[^DAefUZ;^DMM^=j?^DNSn=Z7^"
    "DYHCab7^E1@@RB7^E7KcAb;^E<fUQZ?^EDbPjMo^EHa;9b;^GVjjQn7^Gm:O25g^H:I<Emo^"
    "HFCaifC^HORBAN7^HXL[en3^Hp@ImJ7^HdGAIf;^HhnQUMo^I5pYA]c^I=cPVAo^IBJ`ij3^"
    "IIXgNI[^IQE`n:3^I];7f9c^Jmd9N:3^K7kc5f;^KCfHY]c^KJGJmV;^KUoBUn?^KW5RYZ3^"
    "Kaih=f;^L>I5>23^L?mG]b;^LEH9m^?^LQB_Qb?^M6dPFB3^MJF`^=k^MV<7VI_^Mi^GnJ3^"
    "N_LNmn3^Nfe9:Qk^O:GIR9o^OBj`^67^ONeFEj3^OX3fYJCZO`n@>B7^OdanEIkYOlhef23^"
    "P1P61Mk^P>>=Yb7^PJlEFB3^QCG`JEo^Qb_GZEk^R@MGQn;^RLGm5]o^RRhoI]_^R_W71^7^"
    "RjKLUj3^S3HIBEg^SFjYZB3^SMi^EfC^SYdCmfC^TCmE223^UOk0R:3^U[`GJIk^UoBWbEo^"
    "V9CK=b;^VWFj]n3^V`UK5IkXVmCRaQg[W5JJ>67^W:1ZIUo^W?kYFIo^WF_b5^;^WSMi^:3^"
    "Wd`^>A[^X5EQ2>;^YHl0>Io^YHnkif;^YTaG6Ik^YTiQMb3^Y[JSaY_^Yh8[Mf?^YhCWN=g^"
    "Z2m11j7^ZDBHeb3^ZVKBaf?^ZbEhEb?^[8lY2Mo^[LNiJV3^pFp6FB;^pIQTf67^pRL8Aig^"
    "]AdoUb3^]C^a^5o^]SmiQj;^]_hO9mo^]aDW:Ik^]i6oMQkp^5e79U_^^=knYj7^^BS>eMk^"
    "^OAFM^?^^^GBV1_^_1k?Qio^_1mXbR7^_EOi:N3^`?GVIUk^`Fp:afC^`NL1>>?^`]K5j27^"
    "`cl8=Yc^a0Z?ej7^aLcmAj?^aNP@2:7^aZEVjEk^a^lg9n?^ajgLab?^bjnXNV?^c>PhfN3^"
    "cR39>>3^d>KnMb7^dJFT1ao^dL@F:63^dpOMmf;^dhJ3Qb;^dmdea^G^e1XSiR7pe9_KIb3^"
    "e>F[UQo^eFMS1b7^eGQ?^Eo^eK4c=Qo^eWbjib?^efhfn5g^g7QhVJ7^gCG?NIO^gGi:aZ;^"
    "gK48nAo^gViOf9_^gelZAn;^glMpU]_^h9;dAf3^hIJl5mo^hUEQYf;^hZ`CiVC^hgNKV:3^"
    "hgRQJB3^i3I19j7^jEKaV5g^k0RhBB7^k4dXia[^kD58ZEo^kFmRej7^kRh8Ib7^kcL_j9k^"
    "l0kWmj;^l6FJ=^?^l::8EMk^lB@oab7^lFh?mMo^lSVGYQk^l`DOAb;^l`OKAmg^l`SQ:J3^"
    "m45aR9o^nDZ]B63^nPJ_=j3^o4oA1Yc^o=68FF3^o?cVUb3^oA]HYio^oPXH^:7^oQlPN23^"
    "opM_VEg^o]g65j3^ocAhEVC^oo<Miec^00001fK^05^ZJUK^08:inZ_^0NVO>IS^17TDEQc]"
    "1@Y1V1k^1]:@f];^1ac9EB[^1bCIbY3^1bPXj6;^1c;J>VW^26VP:]C^2=DXZa7^2SjBNV_^"
    "2V<MNQO^2^;VMY_^2aZ1ZY?^2k9BZV[^3AG;9Mo]3B[p^6G^3J]bZZg^3LAEjNW^3_m35Uc^"
    "406=fYC^40Dka]W^47M5RUG^4Ba<fIK^4K:TVNW^4]bK^a;^4`7YjQS^4fhaAn;^4hRgYV7^"
    "56Z@RQO^5:R^jg7^5@B1^QK^5@^]]V;^5M<AYmo^5O3jIB3^5UZ;R9_^5e_IRR[^5fUo:E[^"
    "5o3i1f?^61OFAI_]677aVEO^6@?9QR7^6F54>QC^6JG;6AK^6X^OaN3Y6c>ojIG^76T7R9G^"
    "7@pNJVW^7bQi>NS^816T:6C^8Aai^FS^8B2GbG3^8WUTZQO^8Y]7IEc^8jdn:AO^9CpbnAO^"
    "9Ef=6UK^9EfU]jW^9UpCRMK^9]LHfMC^9^FXjZ_^9j;V2a?^9kCTjbg^:05dMR7p:3Zg6V[^"
    ":TbjFJ_^:__VnV[^:k5Q=bS^;83G^MO^;8Wb>YC^;9RR6RW^;9i=jRW^;F@Y^Zc^;JbPe>[^"
    ";KBa>MG^;Y9>FJW^;d:V2=O^;hY>BUO^<HcV6]?^<ko7abK^<n@mnZ[^=5lafBS^=7QGUmg^"
    "=?oAJ9g^=GM95Uo^=pMdZZg^=kV`Ii[^=k`TFQK^=l:>nNS^=n`[]mk^>76kVR[^>7>UR:S^"
    ">?pOFEk^>H:I=j;^>IianMO^>Pif^R[^>VFl6F[^>gc=J>W^>i^5=Z?^>k3MZNW^?^RBU]W^"
    "?`792MS^?`[=6VW^?b>[aR3^?i>Q1Z7^?n=IZ]C^@3FRVAO^@:@;en;^@=iDN^c^@J=4F6S^"
    "@L>GJIK^@[8gn7;^@^dM]Uc^@`C_9U_^A;V]f4c^A<<KN^_^ATonB]?^A]NE>=W^AhA;FN[^"
    "B@Tl6QO^BA9FZa;^BB46Nbg^BGQ;fJ[^BSdEZMO^BaD6nF_^BaZbbBS^Be?KZ5?^Blp:NEO^"
    "C1:b^QO^C@1B69S^CF7BfFS^CQE:RYC^CeHbfRW^Cgnj:>_^D6bRF^c^D>NFBJW^DIS3F5O^"
    "Da2_>MO^E3ahEBG^E4B8^QO^E4[cJRW^EH9mnF3^EM9mRES^EQ_W>VW^EYKK:V_^E^hPNNW^"
    "EaS[NBS^F3U22NW^F8[KV_7^F927JJW^Fa@iEn?^FhX]NQO^Fj0fJ9S^G:ZVf9k^GFJhjbc^"
    "GT_kbIS^GViEj]?^GbjNJbc^Gh53NAO^GoXV2J[^H0EU>]?^H:hBIF7^I0b_b^_^I4?H:3?^"
    "IE;;f6[^II6PRIO^IJNYNAO^IJUZjg3^IJlF^RW^IP2`>N_^IR=hM^C^IpEj2IO^I];7en3^"
    "Ij<G:>S^Ik=KbUO^Ima05Q[^J5=^f=[^J9pG6UG^J>eP2Y7^J?2_=nC^JS8VJUO^JYf^jUG^"
    "J[F5MF;^JmjG>RW^K_=bn6c^L<c]:QO^L==GbV_^LLXD6QK^L^hn]YW^L_CC6IK^LbC[FRW^"
    "Lbl3]N7^LgJ4jR[^Li0YV=_^LofdV>K^M;chQJ3^MAS[fF[^MQ^KjB[^MW4e:fg^MYeUAZ?^"
    "MYnIN6g^M`ZKAUo^MkV0]JG^N1:AfUG^N2<Ab5g^N2RJbAK^N4bfAJC^NJ26ZIS^NKUoAfG^"
    "NNlMBZ[^Npa?aFG^O1iO^9c^O69E2EO^O8::NJS^O:GIQj?^O?a6:MO^OCIfaV7^Op?0j5g^"
    "PS0=fEO^PS7?Bfo^PXTDZNW^Q2G?bB[^Q2]kUnO^Q6BTMM[^Q<J4Z2S^Q=l5JYG^Q^Ap2BO^"
    "QbHCFQK^R2>Ib=O^RAOS2Fc^RGe[:Z[^RXg0nRW^S3N0nAS^S:`SnMS^S;=?m^?^SEEARQO^"
    "SU9hNUO^S^IhNQO^Sbb`2VW^SgdgRQK^SjNSnZg^SkMX9Yk^SokYBRW^TDELmV;^TJ5@>FS^"
    "T]S^>QO^TbOmiZW^U;3o>A[^U<:36AC^U=DJYNC^U[>G2QS^UfO96MO^V3EgBR_^V7>:ZAO^"
    "V@[^fZ_^VKkK=]_^VS`[b:O^Vp>UZ=c^VdpOMjC^Vdc@1R3ZWSMi]^;^WU[FBbg^W[QbBES^"
    "W[Xc^bk^W[paUZC^W[oORVW^WaLTfRW^X:=nF6S^X;?On6S^X;p:6QS^XE`WANC^XFMYbYG^"
    "XFll:MS^XJ_OjUK^XSQG^E;^XVbB6:C^XW[m^AS^Xf_:V2_^XlI>AV?^YEA35EgZYW]=f>K^"
    "Y_?ZeUk^YfLHRGC^Z699Ffo^Z7H<:NW^ZNW<JZ_^Z][LjYG^Z^V<bZ[^Za17IEg^ZfkLfQS^"
    "ZgJ_>MS^[3Fd:RS^[89`b=S^[8M=^NW^[AaQn5G^[RVdZBS^[k1RARK^p9JgElc^pCUSVQK^"
    "pJFZmmo^pc_kN]?^pd<WMZ?^]GI?nQS^]I=CB^c^^d:H6bg^^dQ3jRW^^in9BNW^_=boYfC^"
    "_D=^RUK^_ONPRYK^_i8NV>[^_jXbnBW^`3KL:QK^`4jb]a[^`?LTZZ[^`Ga<:bo^`Lg[NQO^"
    "`WJHYJC^`WjY5Ec]aW8`bbg^ad[QVUO^ag0_^AS^ag7a:fg^an_naVG^aoM1BUO^aolCZIS^"
    "bAEMjRW^bJC6EUW^bUHUaYg^bn@JUIg^c7h;]Vc^c@pUEjS^cB07VFW^cL782]G^cNGSMNC^"
    "cQ@@n9O^clAOfe3^cnPDB]C^dE9DZMS^dPJ6^MO^dQ^gZ^c^dcM;:9_^e?N:1JO^eFWl>=[^"
    "eLHjf>S^eO4Z61k^eXEneBC^e]djEN3^ecihUEW^em2XFRW^f4>PVA?^f6POb:g^f=pc]JK^"
    "fKA7:F_^fL_BjYG^fM;niZ?^f_VFmUg^gNKUn=k^g`L=MM_]h8a7:23^h9D2B=K^h_4WVA_^"
    "h_ZE>fk^hm=5nUK^hoYEV^c^i8Mh2a;^i;A==IW^i@l>jEO^iU48EMk^iXl:n2W^ing3MAc^"
    "j0`SZRg^j:cbBF[^jTXpJa?^jiU<RJW^k4c4Ba7^kKLcjBO^kMZi6UK^kW_F=N7]kXk[6MS^"
    "kZ@L6fk^l>Gm=ac^lB<>>^g^lRXQeEoplW?b1R3^lkWgZ1[^m45aR5c^m54p^2?^m5=Pj^c^"
    "m:?XJAK^m?249VO^mE1U::C^mMOO2=c^mU9^b5[^m`1C=Ag^mai0ZBS^mn8p:QS^n21:NJW^"
    "n]=e:R[^nnV=:IO^oAEFA:7YoX03n6S^oiofQQ_^000022;^05pWQMk^0EG7Z9[^0FJ;AEWp"
    "0pm2BQG^0^=lER;^16IAVQO^16iXZ:?^1@3V9:C^1CdC:VW^1F_A5RW^1TFZUF;^1lWjJZ[^"
    "2;p8QY_^2M3oJNS^36C6jJW^3G4K>AS^3ZfCZ=K^3_RENMS^4G2cF=c^4H3Z>QS^4PMen9S^"
    "4SDImB7Z50TnnMS^5>16RA[^5OK[>IO^5Q`K=6[^5VbFmj3^5X_fNV_^5Y6C^QS^62<5bRW^"
    "6:A_mJC^6bc4]BC^6nf@RVW^7KDIMRK^7RB9EM_^7eNV^UG^83e^ABC^8<mLV5W^8U^]5j3^"
    "8pG31F[^8`>XUQg^8aO_N2O^8jaMVIO^8nOmU^K^9:@on>c^9DhGaZ[^9XN2Z:;^9XkmJNO^"
    "9mIpQJW^:Q?h]Eo[:hKobUK^;>9XNBW^;_<H1Ig^;_[5F9S^<H<J61S^<WipfNS^<Yh=jRW^"
    "<`mZQJ;Z<aAJfR[^<ibMYEop=0;Y>2G^=@NTJIO^=AHMemS^=INoEMo]>20D5IkY>@RZbRW^"
    ">ZQXeR7p>^:7IF3Z>n0;6US^?53kjQO^?AYSUAk^?C2mUYo^?d>cjRW^?kTBEMk^@3C22UG^"
    "@T5W5Qo^A1gDj:[^A<VkiZS^A[eIn>_^A]7faF3^AaA<:5_^Am>mQ^G^B3@Aj6S^B9m5>NS^"
    "B:2LZ6?^BDj;BNW^BF[<fNc^BRc]9nK^BXKd=mW^Bk4F1Io^CUJ0BQS^CcaZfNS^CiboBRW^"
    "CkTX:RW^D=kE2MS^DC?>VR[^DD1R1m[^Dp5V9AoYD`=RB=O^DfLYbMS^E3S0R>W^EECF2MO^"
    "EGX619c^ENmnRMS^EQ`3=nG^Eblgf1c^Ede161O^Ej25MF7]EmdZbEO^F09JaJg^FTOHb6S^"
    "FXZ_QBO^Fb_JBNS^Ff6e6QO^G;dVJQK^G?eYFMW^GA<4A:S^Gi]I5>S^Gol8ZRW^HR>]eF_^"
    "HhodeIg^I5`QmV;^I:`2UVW^IO<aBN[^ISK^jBS^IVVURRW^IcAGEBo^IdXSN5O^JBeV>=o^"
    "JJlA:V[^JNBZbFS^JV;4NFO^J[VfZ5c^K4H79j7^KUR`:5S^KgmT=F3[LVeEEEoWLcTiV97^"
    "M5j3MF7]M6F?>QO^M<F:6UC^M?3CjQO^MXOS>QO^MZS<b5c^MZn62VW^MggniQk^N3DMAb;^"
    "N=9_M=g^N?5OZ>k^NDF:fQK^NDQAf9[^NHG=bUK^NN:4V1W^NPICYR3[NQFgMF7]NWf`62?^"
    "NfkCUB3ZNjkV^QO^O8jXIMo^OAXRjVW^OaKm9R;^P4gbeEk]P6;IMEkXP>B6EZK^PImAiN3^"
    "PW^EZN_^PmU7^NS^Q2NV]N;pR4b>>NS^R:f86V[^RF<mR9c^RGT?^Vc^S3eRAIo^SF03JRW^"
    "SKA[6MS^T3bofMS^TTBonUG^TUanVRW^TpDDV9S^TlZPBRW^U;;0fMO^U=O`eJC^UDeYFQS^"
    "ULg_>IS^UcpEVIO^Uf15U>_^UfCnRMO^UmFn6IS^V2cAYAgYVGhY9l_^VHkpb6S^VNRJEQO^"
    "VQOE1n;^W73_5:;YW9K:6:O^W@_`iJ3pWSMi]j3^WWX<b2?^W^;YiJG^W_U3iF3^X9M5^NO^"
    "XH6HY>?^XOe8BMK^XcQOeJ7WY0W]INS^Y120bRW^Y1a11AoYY=CbVV_^YP5d:Zg^YY929>7^"
    "Z?]PAEg]ZWpMZRW^Zc=C:R_^ZoEcInK^[54KNRS^[8Je:NS^[?`9AM[^[@RWn5o^[CHE6UK^"
    "[YChN:?^[pdTJYG^p3k_^5S^pl=j2QO^]5>DmN;]]>[?]F3^]T_>bIO^]]_Y]Uc^^F@nMR7]"
    "^`Wp2NW^^`cARMO^^haNNJW^^nbC=Mop_11O66[^_B>CZ=[^_WCWmN3^_`KFF9c^`6LDZ6C^"
    "`9<Vf1g^`=Xo5AkX`?dl]N3^`B^K2VW^`QmgAV7^`XWHRV_^`hFAQRG^aKUNEAkXaPgVAJ7X"
    "bKiiNUC^b_GpN1[^beF8bUG^c2]:^:[^c88lmmk^c<V^ME_^cA9EjES^cPj=IbC^cp[?b:g^"
    "c]jh2MO^cb7229c^ciZZZMS^d:hBN6C^dJS=]M[^dR;oJ=S^dSYRn6O^e12[ZIS^e3GKYO7^"
    "e:]D:QS^eC@RVJO^eYT0JEO^e[h`I>[^em`HJVW^f;TMeF7^fDJ59^[^fY2U]Eo^flkIi>CZ"
    "fmhm]:K^gGp]ZV[^gIPm9F3[gUL^]R?^ga8lnV_^gcb]Z9c^h=n3MBS^hR]O]2G^hUE>VBO^"
    "hfOH=Fc^hkMINJW^i4@KnRW^iO0pmR;^iTKMjUK^img]>QK^jHNpQF?]jb_3b1;^k3:T5Q_^"
    "k<:=b5k^kVK;aEW]kXbEbVW^kicJR5S^kmaRNNW^l>?Yb6;^lC[L2A[^lW0jB6S^lb5TfQO^"
    "lk5oaNCpm5=ln2?^mGLKiQC^mJViVIO^mSWDQN7^n<8YAZK^nP>B2R[^nUHk9QW^nVZlFUO^"
    "ndYn1MopniZQFV_^o=;ojUG^oM;BaZ?^oN6?nRS^01<BARC^04C_UfK^082cbES^0=jImZG^"
    "0=mOenO^0?H?6F[^0B^nnMG^0FgiIj3^0LYN:N[^0ZjVBJ_^0bACVAg^0cC^QYc^0d7fafC^"
    "0jf>a]W^0jfPfN[^0jkBJE_^0kADe^C^0l]429o^0oRRVAW^0oYSn]7^188UnEK^1>F6F6W^"
    "1AnK>5W^1D3C=]c^1Dh[FF_^1E`Jnno^1GXd>J[^1I3SRVc^1VhMmYo^1Z2_5b3^1`;Mj5[^"
    "1bPXif7^1c5^1f7^1d<Pf6K^1e9<FBc^1eefjjk^1k`RnEk^1o^P2o3^22JKJ>c^25jV^=O^"
    "27_<>2o^299kREW^2;jFIbG^2?lG9RK^2@UR5]k^2CF?2FK^2DH@A^?^2Ihd6JW^2JV2^E[^"
    "2K[oJ^o^2L0=jV[^2Lf:5bK^2PWN6BO^2[44Yn?^2pH<AUk^2]iS=e7^2f:Qj>G^2f?gUV3P"
    "2jWZfJc^2n]aIQc^35G5b>W^39H8^>W^3>cXiRK^3CJi5jS^3CX=jZ_^3C`GN:C^3DhenMG^"
    "3FkFNBW^3H>>BVc^3HdKQi_^3KWHB=S^3P90]^K^3Pb1f5[^3Q1VNBG^3^jhb=[^3_RO]jO^"
    "3c]Yj:O^3e8I:ZG^3fI1:=g^3fnlJ1S^3kY0JF[^3mVBnZg^3nfk2IO^41a;:N[^42BDbIO^"
    "47aDUiK^48G861k^49[?^AO^4:o[R:K^4;4M6=o^4<HTbQ?^4CZPNAW^4FFSR9c^4JP_j:K^"
    "4TDWIU[^4YAOb=o^4a_IZI_^4cI1b]G^4fFYf9o^4npJ:]C^50[6j2S^52[i6bg^5?gZ^NW^"
    "5B`Xj=?^5H`HUJ;^5J3nB]C^5LiLfQG^5NQ[B9W^5O?UYjk^5QKkJFS^5S3Cb2S^5pYn:V_^"
    "5]MP>N_^5^4]JVW^5bA[R4_^5b`_>IK^5cP=VYO^5l^]nAO^5o3i1f3P61R39mS^65<Wf9O^"
    "65Y7RIK^67Qbe^7^69=ZanW^6BdE:FW^6EP@N>c^6E]UEnW^6GKUFBW^6Jk`ZAW^6VL4:Fc^"
    "6XGHn:W^6XMJJIS^6ZNbbN[^6_W<VMK^6c]C::?^6h5b>2O^6i8cFEK^70Sp2:[^76TKZJ[^"
    "7=GgBUC^7=d?BIO^7Eea6]3^7L<e=Ug^7P>ei6C]7XL32BO^7Y2@Aeg^7ZQa6BO^7[lPJB[^"
    "7]8XeUk^7]c3Z5g^7_E6AjO^7_kCRBW^7`XR:AO^7ec;b=W^7n8l6=[^816T9f;^83l:ImS^"
    "89TMn1g^8:9S6FO^8>eTfEK^8?0@=Yk^8BR[EfC^8DN0:5S^8EOMAb?^8N4ZQN3^8Nc1B33^"
    "8P5W2Eg^8X[ZJIS^8Y_O2UC^8]j?MmS^8`lY6BW^8gPieUS^8n=h:N[^91c[=Ak^9A0?21o^"
    "9C]T6aC^9Ce]VEg^9DGe1^?^9LJjfN[^9LOpJEC^9Le^ebC^9Q6lVAc^9YponEK^9ZLNEig^"
    "9p_QB>O^9]9cJMC^9cRe>9O^:0SEEfK^:;W95f;^:=C122W^:A_gj5_^:F]VJB[^:R@eJ>c^"
    ":U0fUf?^:WO0bAK^:Y2gEN[^:YCV>;7^:ZQJJJS^:Z^ER=S^:]N`MbK^:dbORZg^:djY6>K^"
    ":elZA^C^:l:L^EW^;1PW>JW^;2;h6BS^;5NpN5[^;8D;24c^;8^M66O^;?FGaV3P;?Mm=lg^"
    ";FWg6AK^;GdAUUc^;L<4jJc^;P>QMI[Y;THmb6G^;VkOb6[^;ZlR^:W^;eDaN>O^;hO`NBW^"
    ";mU`9Z3^<2FKf1k^<2d=R1_^<58@MI_p<>KdNA_^<@OBbAW^<A6i]nS^<C:62=c^<EB3j6G^"
    "<HSFImS^<O:]2RO^<P[_b>3^<Sf^bMO^<WSe=eg^<Y@lnbg^<a:OUV3^<e>jNAO^<f`I6UC^"
    "<l59j6G^<mK7UJ3p=4JjB>_^=8QTj>K^=:0Q^>c^=C?22Z_^=CCcZEg^=YHnin3P=ZUA>6[^"
    "=]_dJ6[^=_<QJ:[^=aL4bVO^=afhaIo^=d;kUV?^=gCHiZC^=hF5eZW^=hc;aVS^=kjY5jK^"
    ">0m9:FO^>1`[>6O^>30ENB[^>5QCMV?^>>Nbj5_^>Cf5R0[^>DE9>IS^>H:I=b3P>PXC1f3^"
    ">RD:ibS^>W7P6:S^>[^`B2[^>_p]FUC^>bR;jUG^>ceWaZC^>nD`::g^>oRBAm[^?7hDZZc^"
    "?80N:BW^?98lZIO^?9kbnB[^?:1dJAG^?<MW6:S^?@ALj1S^?A;VVES^?Ih7ANG[?QYXV2?^"
    "?TO79]G^?X8eZF[^?a=>bBc^?eCEEY_^?hj@2]?^?iEF5>;^@3VKBQC^@6?91Yk^@6EhFJ[^"
    "@=PjJJ[^@B<l:=S^@CW7Jbg^@D=DZ1[^@GGUb9g^@M2ZV=O^@RZn9j;^@X6`EMo^@[]m6FG^"
    "@]TPFEC^@`InfMC^A0GKB;;^A1U?NFW^A1Z12=c^A70_ZAK^A7hOBUK^A:@4JES^A;d4eaW^"
    "ABQ3:JO^AObB:F[^AV]C>jk^AX?in9O^AYHZNaO^A]NE=^C^A`UlBfo^AafTFe;^AfjD>YO^"
    "Aj`mimK^AlTUVBK^AmoDfNW^AoH>6YC^B2[FV=_^B;AIn=K^B<gZ:Z[^B>CkFBW^BDfPFV_^"
    "BE7?>5O^BLA96N?^BPhIBEW^BT_2nI?^BYFC:Y?^BZfH69[^B]mSF=C^BcDAj=c^BgEDf:O^"
    "BhB0JB[^Bn7Faf;^C29GQJc^C5`B>QG^C6U@UfC^C7W7MYk^C:h0B?7^C?3:MbG^CF2m6B[^"
    "CFO36>G^CFfO:>c^CGLpIeW^CM1X6N[^CM^f^=O^COYWNV[^CPM9R^c^CQ3FaYg^CS`B6>G^"
    "CXLgmb3PCYhU20c^C_^GBMC^C`jaaQk^Ca2G=lg^Cl=D5nS^Cm@12A7^Cm`NjFc^Co8pEb;^"
    "D0dTB:[^D3DdEmg^D8Oib6W^D:K>VZ[^D;1Kei_^DENL:2?^DO1VnBS^DQ7E26?^DRVejQC^"
    "DSjef5[^DTHWR1_^DVplN:[^DW>66MG^DY4YEjO^D[5KRbg^D`0>NB3^DcSEFbg^Dgp85ek^"
    "Dj7`ImW^DkXc9jG^E0_72V[^E5K8bMK^EE3PV^c^EFQWaQ_^EFcDN=O^EHDc6a?^EMQJJVk^"
    "EMYSn:G^ENDlRJc^EWR=2FO^EZ5nj>S^E_kEAF3PEdcL6NS^EhI?9B;^F0:D69C^F2OO5n3P"
    "F3[aJBW^F3cjj2K^F6fDV>S^F8C1VJS^F:mHmQg^F=6Fan[^F?@8VJ_^F@Ii26W^FC0NbRW^"
    "FDo;QmW^FHT8N5g^FPBSjEO^FPihb1O^FZ8I:9O^Fa@iEj3PFeJORRS^FeiS>IW^Fi^c=mo^"
    "G3ohFAS^G;LW6Ac^G?JT:jo^GD6UjQO^GML7Z1S^GN4T^9O^GNNJj9k^GPEGeac^GT4DEfG^"
    "GUOMJ>[^GYGm69S^G[P=2B[^GpR>=b7^G]mG>:O^G^2166K^Gb`0ZIS^GcRnY^S^Ge081ek^"
    "GhaL2FG^GlAWJMO^H8ho]nK^H9]?^:[^H>IeQ]c^H@m3FEO^HBKfAEk^HBaXbBk^HFnN^NG^"
    "HI4<f>O^HMQ3^Fc^HM^HV6S^HOEY=Z3^HQR6Y^C^HZOV6:7^H_5DJB[^HcaF>=K^He;QJbg^"
    "HeWiJ6S^Hn5cAnW^Ho>Sb6[^I1=@QQg^I1A`69_^I74f^=K^I7pMY^O^I=BG6>O^I>Ro69W^"
    "I?8jF=S^I@Ym5j7^IAnHjMK^IQkeB;;^IS9YNB[^IS>K69_^I[dNJEO^IaJaVBW^IbZ]f2G^"
    "Id5M:JS^Io78f:[^J1Fp:JW^J1KMb=o^J69_FQG^J6TeE^;^J8A]>fg^J?2_=bC^JJSNQUg^"
    "JL@VBno^JMD;R:S^JN8oVBS^JOS^fNO^JY`2JUO^Jpecn=O^J]7XIN?^Jf[Y>5[^JiUiJNW^"
    "JlF2BVc^K6>[Ffk^KDh[j=_^KG5]Mak^KG=fmf;^KIfJJFW^KK?g]RW^KO[`aj?^KR<:^Jc^"
    "KX9ZYb?^K[be5N7^KpLJB;C^K_9MAbO^Kd`DRRg^KeFQamO^KnV26BW^L1SH9j3PL:1AmV?^"
    "L;Lo2<[^L;gA66O^LBVa=lg^LECd=ZS^LH?<QfC^LI5pB9O^LJ8IBV_^LKI1BMG^LN^IVNc^"
    "LODhj>_^LR1ki^O^LRpFZQG^LSEYb2K^LZ4Cb:W^L[LQB>W^Lg2f>2;^LkXTRJS^Ll8UnQK^"
    "M46NFNc^M5G6F9c^M5O?f1[^M5cV65[^M5m1Um_^M8AFR>_^M8bP6EO^M>AOimK^MATXN>3^"
    "ML60ZA[^MM==:2;^MRCQ2VO^MVoRbMK^MXd8BJ_^M_X7mN7^M_a[:9g^MeR?mik^MfV4VYC^"
    "Mh?Tn=[^MhG^RAS^Mii=6YK^N5<UNUK^N7<mmUg^N96W6BW^N9<4JR_^N@2CjMK^NAO_AB?]"
    "NFLWZIk^NI@dB9K^NKUoAn3PNPT9Ze7^NSIX:i7^NT3i5Yo^NUHDj2G^NU_a1io^N[o[RJ;^"
    "Nc:9NN[^Ncm[V:S^NdThbRS^NfSUR1[^Ni@jREO^Nj0HnUG^O1fmjEO^O<9Bj=K^OBakNN[^"
    "OGMm>IK^OIDPNFW^O]1169g^O`nn:o3^ObGgJY?^OeZojUK^Om:dQjG^OoXn^9S^P02dj=_^"
    "P5X^IfC^P=4W2F_^P=:XNAS^P>6X=^7^P?VK6:S^PBEB29?^PCh2Ve7^PDDJZIO^PFTR1fC^"
    "PLElO0o^PWPE]Yg^PZMI^2C^P[AY^JO^PbQMFIK^PdF2fBg^PhL9I]c^Po5M^FS^Q5=`Z9C^"
    "Q:4iZ5o^Q:LE]mO^Q@Y^JF[^QCQ^b6[^QD305EcXQEE`>=S^QJC`]R7^QJPIb5[^QJ_nJJW^"
    "QJn;N1[^QKoXYjS^QR^0Va;^QRf:65g^QTTeeUk^QXY@^=_^Q]REEak^Q`?ZF]C^QcRbjEO^"
    "Qcd=RFg^QgQV2MG^QmJgjbc^Qn159Uc^R25P263^R3P?F;?^R4^3NF[^R4be6=_^R6nTYZ;^"
    "R=HhJJ3^REYg:FW^RJ=_J]?^RP[Rf:[^RRk6:JO^RRogb>3^RcYn^5O^RjINf2O^S839jZ_^"
    "S;DLJYO^S@Q3^^g^SAL_FBS^SD2YB5o^SH@3>5W^Sc9mJEG^SdFGiVW^Sf[J^^[^Shb@mf?^"
    "SiGF6BK^SkBZjRg^SkJdJFS^T1@:af?^T1`NEf3^T7NY2:O^T>0dBCC^TE3nf5S^TGiMJAK^"
    "TM82N=G^TP:L6N[^TPgZ^=W^TS7b9R?^TTWU26_^TV^peA[VT]1I24c^T]K[::[^T_p<BAK^"
    "TaEp^6C^Tb<<M][^Td;;B4g^U0BcZN[^U0iBjB_^U45kQQ_^U;XKaQS^UAa0b=W^UGW51nS^"
    "UIZAF1k^ULGVJMG^UR:JnF_^UUZhFF[^UVRWmZ_^UYe`R:_^UZFj:EO^U_a8FF_^UbG2Aeg^"
    "UgbdMZ;^Um@TJES^V3gk2JK^V44f:1_^V8SlfEK^V8^X9J3pV:k5VBK^V<R_nMG^V@P]2>g^"
    "VDQ_mJK]VI_=J>O^VIco2A_^VIl8R9[^VMO?JFg^VXaGmMc^VZV?M>;pVZ[16BK^Va5LUnS^"
    "VdpOMn3PVeppb>[^Vgl@6Jc^Vh11^Ig^Vjp6mF?^VmcT=^C^VoCG9^O^W1RXJaC^W6l^n2?^"
    "W7J>UNK^W7MDNBW^W8@fV6?^W<1NaZ;^W<>cZQK^WF9BbRW^WH7oR1S^WJeDVEK^WTJJj2_^"
    "WYXhBFS^W]W[N>S^WdK76AK^Wf<h^IK^Wi2GBIK^WjEc5b?^X;N?f1O^X=_E6Fo^X>HP2Nc^"
    "XBSH:fg^XFAD]b?^XFaX=ic^XN_>QfG^XPHBUZ3^XQ=H^9_^XW=8I^3^X^Y12F_^X^_2N9S^"
    "X_E[VZW^Xa:e:6O^XehdZIK^Xi>DZ_3^XoJKJQK^Y0VeiYo^Y4XfYZS^Y:6VVMG^Y<f3^BS^"
    "YARYUYc^YEjLfFg^YJ7B^R[^YN<7FAG^YSlp:9g^Yb>8NBW^YcJ@iMo^Yd4[ZAS^Yfj:>AW^"
    "Yhh0e]W^Yl4cb9c^YlRUR5W^Z:=Z^9[^Z<j]]jW^Z>HZVUG^Z?f61j;^ZA^2jZk^ZBD@9a_^"
    "ZE7<jEO^ZI606EG^ZVG?6=c^ZWcP>9O^Z]=NRV_^Z^mBJEo^Z_hefMW^ZaYER5S^Zg67Zfk^"
    "Zg>A:FG^ZhF_ZUC^ZmJOVYG^[1A9=eC^[4OP:FK^[4TAb9o^[5hIJY;^[85C=Ik^[FRHYnG^"
    "[Kmhf6W^[PK1b>W^[RaDNF7^[WHTZ9[^[[?>B=K^[]99NIS^[_fNNIO^[idMB5[^[l;]^bc^"
    "p<@MVIG^p=Lh1J;^p>3Q:MK^pJFZmf;^pLS8J>[^pV9bb^g^pVmDjVc^pWSR:5K^p_U>B;C^"
    "pc`HMj3Ppf>RZIC^pfXHf1_^pk1gf=S^pl>BEV?^po8l>IK^]1^f6J_^]2]OInO^]3`<JIK^"
    "]6;o26S^]<D9bR[^]?05::[^]@kInRc^]E_UB4_^]Q2mZ6O^]RMpjBc^]Y71BQ?^]]=7f:S^"
    "]aUVfR[^]j3P^N_^^0ZMUm[^^3^dnF[^^44CEjC^^7?BFB_^^95eUmk^^;kD:EO^^=agEnG^"
    "^=kpV1[^^@iDYUk^^CkLB1[^^DkEIFG^^GHQ^2O^^KS[nNS^^NdnNIK^^Qe8EN;^^T1UbJ_^"
    "^ULE2RO^^Z8FfMK^^ZR=2:K^^ldZ:I7^_3p_YFG^_6ZOImG^_:;l^BW^_;8XBNS^_<2Omf?^"
    "_<?K6BS^_=boYn3P_=mdb1O^_>oAibW^_IPZ6R_^_IUK^E[^_WJ45mO^__8ORF3^_a0^M][^"
    "_g]pbR[^_mAFN1k^`4oajAS^`5j3FAO^`:P3^9W^`;=BFBO^`==H^]?^`Ej_N^_^`JVaBIO^"
    "`]2Yf5O^`_Gdib7^`eVC66K^`ge^]fC^`j39n:;^a0CXUbG^a2ab^5[^a8]:Qj?^a;?pRE_^"
    "a@=K2F[^a@CLN5W^aB9o^2_^aB_?:6O^aDiLf1;^aGM>ZI[^aI]F5V;^aJWiQ^K^aK`Z62S^"
    "aLkR^2C^aMNZ2>[^aM_FeVo^aR;?ibG^aT1?6J[^aT>Siik^aWk@Yj;^aZY9]Z7^a^BD>Zg^"
    "a^JM^>C^ac1]j:G^ak[p^R[^anR1J6[^ao`QF=K^b2>AbFO^b5^_:6W^b<Pa5UW^b><XmjK^"
    "bCbRNFS^bE3:N1_^bHNT>=W^bMY=f9[^bXlV>9c^bY^VJAS^b[b4^9W^bg5TeV;^c5>D61g^"
    "c7kY6=c^c9GjB1S^c<YjZIK^c>ahRV[^c@QpNAg^cC=_R5S^cGGkj:O^cHb[:BK^cQ3Yiag^"
    "cR`aZfk^cSdFf6O^cV3j>FO^cYY]=Ik^c`@=^i?^cfHPZJ[^cmRBf6S^d2f=VBS^d49YN=[^"
    "d9pM2YK^d<^f^^k^dKHgB9[^dT55j6W^dVSH=J7^dXpF6F_^d_Wk:IO^daejQZO^dbC0MBGZ"
    "deYXU^O^djLmbJS^dk@OjNc^e<fhYf3PeA9XB;G^eEDbMV7^eGblZAO^eKcoUZS^ePXTV:O^"
    "eRO7f1_^eSC@:R[^eU>TnFc^eY<R2a;^ep20Ve7^e]ELIN;^ealpUf?^ebOcn>[^egCoB4W^"
    "ei26miW^f1H9B^c^f2WGZ:K^f2XaFUG^f9aAR5O^f:[KBEO^f<CaJ9c^f>aQf6S^fDa[AeS^"
    "fUiL=i_^fXcpFF_^fYodeY_^fZZ?V1k^f[[p^6K^f]O^:AK^ffAfN=_^fjkXQVC^fm6?je7^"
    "fn_`F5W^g0IHNMW^g6CPMn3^g70_2NS^g;p`fMK^g=]9B1O^g?p?b>_^gFRO>QG^gLc?eJG^"
    "gLlc2=_^gW4DnM;^gYicR]C^g]ce6FS^giZDf>S^gk546JW^gk9e^E_^h0PTB=O^h@piVIc^"
    "hIB6bR[^hK@cR5W^hMn8V=[^hQ_^V=K^hZ5`n^k^h[FHnYC^h`J1>5S^hgO9Nbc^hhh2^e?^"
    "hl;;BEO^i69:29O^i>W3j5S^i@l>ib7^iBX6f:[^iCTbFB_^iIJ8]fG^iJH=n]C^iN>gV=G^"
    "iPf1J>W^iRf7be7^iTF<^9W^iWUQNAW^ipd6VES^iaae2FO^ibcfAbC^idCY:2O^ifMff97^"
    "ifefmJK^igPAaeS^ihDJ2Vc^ii1XZIO^ikA`5^C^io@6jUK^j3_YibC^j<E9=e3^j@FCfBc^"
    "jDV7j:K^jGXQV2O^jI3@fJ_^jIln>bc^jJS;MMc[jQ@9b:K^jUWAAU[^jY>;nQC^j[51=Yg^"
    "jb;mJ:O^jeFlN>S^jf_e^]C^jj2n>=W^jjDHjBc^jjjV9iW^jlJ72:S^jo=Wf5[^joM<NFS^"
    "k3k3Bbk^k4Q@Qao^k72PV6S^k=FNb9_^kEJRJ1[^kL6ZVQG^kL>d6EK^kP<a:>_^kP]jbY;^"
    "kTU@:fg^kVb^5mc^kYKARBO^kYP36=o^k]3:2bg^k`FBVJ[^kb66NEc^kcWU6IO^khlEj:K^"
    "kj::65S^kjG5:>C^l;>7AAk^l>SEBno^lAdWbi7^lG1?737^lGda:Ng^lGlj^N_^lO6pj2O^"
    "lSUcRBO^l[@g6YC^l^C@^R[^ld]p>V[^liZ8^E?^llmAB=_^lm;V2^c^loYhIEc^logQJFW^"
    "m19[F:S^m1bf>Nc^m9i]^Jg^m>Pmj:W^m@]AR8g^mA<E>MO^mSX=b9K^mUmHeb3Pm]>h9Q[^"
    "m^KBYZ7^mb^2BCK^md9;EjW^mhpGe]_^miGFZ=S^n4gZ:F[^n6bnnF[^n=VJVe?^nB8W9Mc]"
    "nFklF9O^nHhIBEg^nPVlJ>7^nRga^9O^nY4fBIO^n]2cA^G^nfACYfK^o36E1Qc^o3cAV9[^"
    "o7Mf=i_^o8mG6:K^o:H6J>c^o<>YV1g^o?48:EK^oAK@n6S^oD28YUo^oG0hJB[^oG4@Aic^"
    "oG>=>:S^oK1kEVC^oSoJbR[^oXU96N[^o_ASAiS^oei`1NG^of8ji^O^oh^HMfO^onQ=2A_^"
    "0000:5k^0000N:K^0000ZJ[^0000b23^0001Mj?^0001Ua[^0001ij3^0002>F[^0002F5o^"
    "0002in?^0003B5c^0003ZB_^0003aa[^000465S^00052Fc^0005R5O^0005]mo^0006N>O^"
    "0006n5S^0007Mb?^0008>c3^0008F1[^0008img^0009223^0009ZBK^000:6Y;^000:N2?^"
    "000:V:W^000:aIc^000;5iW^000;en3^000<22O^000<R1O^000<bBC^000=B23^000=N2S^"
    "000=imW^000>>:C^000>Uf3^000>^27^000?2F[^000?>Fk^000?Z1o^000?n6O^000@1b7^"
    "000@MQk^000A69k^000A>AO^000AIj;^000Af9c^000BZ=K^000Ban;^000CV1g^000D6AC^"
    "000DAak^000DR>O^000DUjS^000E1ig^000EF67^000ER=K^000En:S^000F1V?^000F5bO^"
    "000FN=c^000Fj9S^000GJ:3^000H>9S^000HZ];^000Haj?^000IZ1K^000In6;^000J6=S^"
    "000JRJ_^000JUR3^000K1m_^000K69?^000KF>C^000KR>O^000L1ec^000LN1c^000Laj?^"
    "000MBYC^000N>63^000NZAS^000O9RG^000OZAC^000On:K^000P5jC^000PBBW^000QEnC^"
    "000Q^J[^000R1mg^000REnC^000Rb1_^000S6B_^000SJ5_^000TRJg^000Tn5W^000UVFC^"
    "000Un6G^000VJ=_^000Vj2G^000W^NW^000Wf1[^000XEf3^000XMn3^000Y6Zg^000YVES^"
    "000Yj2;^000Z62W^000ZQZ7^000[2EW^000[En;^000[n9O^000p]mo^000pj:K^000]J1W^"
    "000]^>G^000^:27^000^N:?^000^ZJo^000_Mb3^000_V5g^000_iV?^000`V=S^000`^6?^"
    "000`fB[^000`if7^000aFIG^000af:K^000an9c^000b:AO^000bB2G^000bEek^000cB>O^"
    "000cR1c^000c^27^000d22S^000dMYg^000dnAG^000e5m_^000e:5k^000eN6W^000eimg^"
    "000fJ=W^000ff:O^000fiYg^000g^AS^000gf>[^000h:UG^000hB6G^000i5Yg^000iRIK^"
    "000j2V[^000j5fG^000jR=C^000jf:?^000jn1_^000kN6C^000kj9[^000kn9?^000l>6G^"
    "000lJ6O^000mF1[^000mYn7^000o6=k^001022W^0010R9g^0010f6K^00112B[^0011:N_^"
    "0011N:?^0011mYk^0012=io^0012IZ?^0012VF_^0013=bC^0013Ef;^0013ZIW^0013^IG^"
    "0013nFc^0014N=W^0014Ymk^0015J:S^0015j9O^00161f3^0016f6C^0017B1W^0017N9k^"
    "0017ef?^0018Vbg^0018]m_^0019>9g^0019In7^0019nB[^001:NAS^001:b2?^001:n6[^"
    "001;N1S^001<=mo^001<IfC^001=:BK^001=Z23^001=mnK^001?223^001?J6W^001?V:g^"
    "001?mn7^001@Ef7^001@aiW^001AVAO^001Aaeo^001B>5g^001C2=K^001C9nG^001C=eg^"
    "001CY]W^001Cmf;^001D9n;^001DNAC^001DUf3^001Dj:S^001Dn2[^001EIm_^001Ef=K^"
    "001FEnC^001Fmj3^001GB5[^001G]j?^001Gb9o^001HQZ3^001HV9O^001I2U?^001INNG^"
    "001Immo^001J29C^001JN5o^001JjF[^001JmV7^001KJ5W^001K^:G^001LF6C^001Lb9g^"
    "001M9n;^001MF6S^001MVQC^001NR63^001NVU?^001ON2W^001PB2K^001PNNW^001PZB[^"
    "001Pj:K^001Q]f7^001R2F[^001RF=W^001R]j;^001S:5o^001SNB_^001Sj5S^001TjJc^"
    "001UF9O^001VB>W^001Vb5S^001WAjG^001X2Zg^001X>1[^001X]ik^001Xf27^001YNNc^"
    "001YnMG^001ZB2;^001Zimk^001[FAW^001[Yj7^001[f2G^001pF5O^001pZFC^001]5n3^"
    "001^26;^001^R27^001^fF[^001_2^k^001_9ik^001_eb7^001`AR3^001`JBW^001`j9_^"
    "001a6AO^001a>>G^001aAf7^001aZ=W^001af6S^001bN=K^001bZ2G^001bmZC^001cJ2O^"
    "001cVBS^001cj=G^001d1mo^001d5ak^001dJ:O^001dej3^001eF=G^001eQf7^001eb>S^"
    "001eefC^001fB1c^001fZ=C^001f^9O^001g>:G^001gB5k^001h29_^001hNa3^001hZ2?^"
    "001iN1K^001ijAO^001jJ2S^001jj=C^001k::?^001kf27^001lB9K^001lV6C^001m=j7^"
    "001n263^001o1J?^001oN9W^0020f27^00219jG^0021RJ[^0021n5[^0022V5k^0022jB_^"
    "0023Uf;^0024FFc^0024M^?^0024f1W^0025b:C^0026>=O^0026aj?^0027:6W^0027R:W^"
    "0027Z1[^00289j?^0028En3^0028Yi[^0028j^o^0029JAO^0029^27^0029j2S^002:Ef?^"
    "002:fIO^002;9n?^002;b1O^002<6>C^002<Umo^002<^6W^002<b2O^002=>5S^002=R>G^"
    "002=n27^002>F>O^002>NRk^002>ij3^002?Af3^002?]ZG^002@JEO^002@R=_^002@]f;^"
    "002A:AO^002An=S^002B66K^002B9j3^002BV1c^002C6:O^002CF=K^002CQn7^002Cn>7^"
    "002DEZ7^002DbAC^002Dmao^002EB:O^002E^9W^002F>=[^002FZ2G^002F]Uk^002GR=O^"
    "002GZNc^002GnQG^002H62C^002H:67^002HiF3^002Hn5K^002IJEO^002IR1c^002IfNS^"
    "002Iif3^002JFAC^002JZ>;^002Jb1_^002KAj?^002KV:7^002K^9_^002Kb9G^002L6:G^"
    "002LB:[^002L]ic^002MN23^002N:1_^002Nj63^002Nn];^002O62G^002PF63^002PZ>S^"
    "002PfBO^002PnF_^002QYnC^002R5j3^002RJFc^002S1j;^002SRU?^002SfB_^002U>>W^"
    "002U^5O^002VZ2C^002W:5[^002WY^?^002XJg3^002Y223^002Y>27^002Yf>G^002ZB9O^"
    "002ZJ2K^002ZV2?^002Zb:_^002[>:[^002[V>K^002p1n3^002p:BS^002p^9O^002pnBK^"
    "002]B1o^002]N27^002]anG^002^f27^002^jES^002_>B_^002_JJc^002`9j?^002`U]c^"
    "002`afC^002aBAS^002aJ=O^002aV2G^002ainW^002b29_^002bf=K^002c1io^002cb63^"
    "002dBAC^002dImo^002d^:[^002danS^002e=eg^002eZ=K^002f::W^002f=R7^002g69S^"
    "002gV:3^002hJ=K^002hQj?^002hfa3^002iEjS^002if5G^002jB5k^002j^FS^002jaV3^"
    "002k>=S^002kR:C^002kYj7^002l9jG^002lZ=O^002lmn?^002m:6O^002mJQG^002nF63^"
    "002nJIK^002oEjS^002ob5o^00306:K^0030N2?^0031>9k^0031Qn?^0031fF[^0032Qn?^"
    "0032n=_^0033B>_^0033j2K^0034^Jc^0035:9S^0035Ej3^003662C^0036V9S^00375fG^"
    "0037fN_^00381m[^0038Qio^0038Z23^0039BNc^0039b9_^003:62;^003:^23^003;:9g^"
    "003;Qn;^003;^2S^003<:5S^003<imo^003=66K^003=f:K^003>F27^003>ZBS^003>f^k^"
    "003?Y^7^003@5R7^003@^5c^003@j=O^003A2NG^003A5j7^003ARAS^003BB=O^003BMn?^"
    "003C^=G^003Ciek^003D>6S^003DYeg^003E:AG^003EEZ3^003EV:O^003EYnO^003F65O^"
    "003FV=[^003G26O^003G5eg^003GjEO^003HBa7^003HN1o^003IA][^003I^EK^003J>2O^"
    "003J^=C^003K2:?^003KV:W^003KZ67^003L65g^003L:=C^003LJ2?^003LV6O^003MR1c^"
    "003Mf1o^003N1jC^003Nij7^003OB9k^003Q26G^003QFJ_^003Qmn?^003RImc^003RbB_^"
    "003SIf7^003SjEO^003T:Fg^003TZ1W^003UV:S^003V6=S^003W2:;^003WN1W^003WmfC^"
    "003Xb^k^003Xieo^003YJ=_^003YR27^003Z:>W^003ZZMW^003Zmn?^003[UjK^003[j>C^"
    "003pImo^003pRFO^003]F:C^003]b27^003^::;^003^FZ[^003_=n3^003_QfS^003_^>_^"
    "003`>=S^003`F=[^003`Qj?^003`n5K^003abES^003aj:O^003amf7^003bJ1c^003c>=K^"
    "003cEj7^003d9b3^003dVAC^003dan7^003e6>S^003e::[^003eR5_^003f29O^003fQjC^"
    "003fn1[^003gF=S^003gbIK^003gj6G^003gn1_^003h]Qg^003hb9K^003hijC^003i>MK^"
    "003iZBW^003j:9G^003jN6;^003jV5_^003jZ>S^003k6:[^003k9^3^003kV9[^003kj:C^"
    "003lR2;^003m21O^003mAn7^003mN6K^003n^63^003nbU;^00002>3^0;fpjIG^0<CdFJW^"
    "0Khe9Yk^0UH<nFO^0ip42N[^19A4eYc^1=RQUiO^1@Y1Un7^1B`LZJ_^1J6?M^?^1QP_MmO^"
    "1W4C^N_^1YnYAn;^1bLS6=O^208pB:K^22P7JUG^23HFb=S^2=?_R5_^2?GRUIg^2DLSFJ[^"
    "2FpmJ:K^2K@oA]g^2PCFA][^2Y[g>>W^2Z[;>5g^2Z_A66C^2]Pkn6K^2_hG6]C^2b9a29O^"
    "2jWZfNk^2kVnj2C^31dc2JW^335T^5S^3;SNRF[^3=[Uii[^3Ji;Z2O^3M@VbQO^3ZHI:27^"
    "3_=2^N[^3k3eUmW^3kD<eb3^4<@0R2?^4BDCjAW^4XL5B5S^4eYZn6G^4h166MO^599n1ak^"
    "5EdDmmS^5J5a]mK^5M<AYf7^5^3oQeW^5^85F=g^5fQiF>W^5noc>EC^63<TUmS^6?kVfAO^"
    "6BaUNMS^6`TdB1S^6g>KEio^6lKW:QK^6n]165W^71_YRBS^77:jnJ_^78:?1f?^7?Xdb5S^"
    "7ADZIR7^7H6^VBW^7I62Yf3^7Mm3mmW^7RhT22W^7WLK]eo^7YcffEO^7jIOnEO^87gLj5g^"
    "8:lEBA_^8;ECZ1S^8G<6RQO^8Hc@V6C^92<k5f?^9ME>65O^9P09jFS^9VY1b1S^9_U:ab?^"
    "9alUfUK^:;S3B1[^:=HIVNW^:D0m6Fg^:LNfn9O^:LmJI^;^:ODeRUG^:gB3J9G^:j`YB^g^"
    ";3a[In3^;:EZ5R7^;;@A>1[^;<]5>QK^;C^;2B[^;D]O5^3^;DaTjJS^;L<4jEC^;TYn^B[^"
    ";UYBaf3^;X8hnR_^;pnn6VW^;]7hR=W^;j5DjQK^;nd;5nC^<0LO>:?^<DJ]263^<EQ8VR[^"
    "<GhS^=S^<RWF61_^<UFPZ:K^<WMTRQK^=2iHBN[^=7QGVMW^=:C0FFO^=c<Aie[^=enBZ=c^"
    ">?XIQjC^>H6CF=G^>H:I>1c^>MYgZNW^>PT=>Jg^>Y2721O^>YPZQ]g^?@DkQf7^?Fhj=Qk^"
    "?PAK:>W^?Q@_:1k^?X_DnAW^?a=>bB_^?b<Ref;^?i[8Z=S^?j0;JM[^@292NBW^@4A9eYk^"
    "@<o_An7^@Pmm627^@aYIQYg^@ai`ab?^@k8aF:K^A2eTN6;^AO1Y=Yk^AXQ0n:K^B<IhiYc^"
    "B@[EZ1O^BEi@Z:S^BH@[bQO^BTYSMe[^BT]YB9k^B]7MB6[^BeUG:AC^Bib8Q]c^C3APF2G^"
    "C5XkNYC^C6Q:b=S^CIeaN>O^CQ0@21c^Cpd[>>S^C]coAmg^C]h566G^C`Y`22G^Cc1;6a?^"
    "CeBU25W^Cm`NjNc^Cn_bj2C^D6>H^9S^D>pBRF[^DPIJbUK^D]Q=>27^DbEf^FW^DnM0eeo^"
    "E;J?EnK^E=aZNQO^E?HdR6?^ECLc9b3^EEM7nES^E[TiAmW^EhbO1nG^Ek9j:QK^FHm8mm_^"
    "Fa<cQi[^G28W>AC^G6EHZ1W^G:VQ22S^GEjINMO^GUI]MnW^GVLI6B_^Gc]XB1[^GjG?Eek^"
    "Gm8Pn=c^H0k>1^7^H1ee:5_^H:C^nF_^H;C31b;^H;G8fBO^HBaXb9S^HK?RZB[^HL>f]f3^"
    "HQ5gn9S^HXHc:MG^Hg236:K^I;0@n9g^I<2=J5g^I>N7ZAK^IGmOIZ7^IKl4V:G^IkfGF5[^"
    "J5E_5^7^JY>Vn=[^JYaeb1W^Jb]na^7^K>[gB9G^KCMdj:K^KG9a:Jg^KOWZn5O^KP6>M^7^"
    "KRMYRYG^KjJgJ9O^Kk4j]^?^KmiMBR_^Ko1DRBW^L=NN5Qo^L>I5>1[^LFfo6>W^LGfC5]o^"
    "LGjHj>K^LODhjEG^LWbb^B_^LXb6ab3^L[ApnNW^L`@pVAS^Lh^VJ>_^Ljf]aZ3^MANFN:K^"
    "MGSQ223^MHYlZRW^MX:NFA_^MX>mMZ7^MXOD^6O^MiK8En7^N62<BR[^NEW=9^7^NcJKnN[^"
    "Ng4:b9o^OK?7J9C^OPb[ZJW^OS]1>>_^Op:k25O^OpYNQ]g^OnP=YnO^P2V1]nK^P>:kFJW^"
    "PJ1^=Uc^PSJ?:>W^PTIS>5k^PTMY2BO^P[h8n=O^PdF2fJc^PeEFej7^PkS:nJS^PlclZ9S^"
    "Q5AfNB[^Q7Imiag^QB22YQk^QT6a:27^Qdb=Q]_^Qe2TaV;^R5nHN6;^RB8DjAc^RR:M=a_^"
    "RlPCf6G^S?Rpi][^SCd9Z5O^SI24Z:O^SKIObQO^SWbGMmS^SWfMB1_^SYmhFFS^S`@AF:W^"
    "Sh^;:EC^SljlUa[^T6JDEnC^T8a_NQO^T9YnfAS^T;3M]j;^TZC<=a_^T_mO>:S^T`lcB5k^"
    "Ta0i6:O^TcbT1nG^Tf9o:QK^ThKI65W^TkN1RJW^U0iBjNg^U1hVn2C^U1lpb>O^U9G<^5S^"
    "UAe6VFW^UJC0J=_^UQ:c^27^USR>bQO^U`Z1>27^Ub1BR2?^Uf4bZ:S^V1Udimk^V>S3EnG^"
    "V@jNNQK^VBQXR:?^VkkC1nK^VnB^:UK^WI^QjJW^WL5ln5[^WSMi^1o^WYCR]nG^W[ZmfQK^"
    "Wc]QV=k^X5AK>=K^X5EQ223^X=_E6Fg^XF=>j9O^XF[bIjC^XI3=NQK^XJSW1Yg^Xa0KF5G^"
    "XdO1>Zc^XffLF5S^XmT9=f?^Y4421^?^Y4=XaN7^Y4nY:1[^Y6KM:MS^Y=LRn:W^Y>Kg1^3^"
    "YEjLf=K^YNHFZB_^YT>p2=S^YVf@NAW^YccpfQO^Yj:g:>K^Z>94n9g^ZAVkZMG^ZK6CMYo^"
    "ZO4hZ>O^Zno;F9W^[8NS9Uk^[pGK2ES^[efbaQk^[mRFAic^p9JgF>W^pAd[F5O^pJBU:Fg^"
    "pR`Nn5S^pS?2MMk^ppWgaj3^pjY7QeS^pmS[J=W^]12ABR[^]:3CMj3^]:7IB63^]@WB9Ac^"
    "]AQiB1_^]H3d25O^]Ioc6B[^]Jo79eo^]RMpjEK^]ZkVb>_^][jjaf7^]^JPnJS^]cIPV=W^"
    "]kgJJ>W^]moQeQo^^6^7>6;^^JpE223^^Kb`ZNW^^[GaMQo^^[X8]jG^^lSlJ27^_9;0FR[^"
    "_H`19R3^_R?HnFS^_fS?nV[^`68@eQg^`?WXVJ[^`En7J6O^`NGkJ1G^`NL1>1g^`SkOZR[^"
    "`VeeB>[^`_C_69K^`cPPQUg^`lohB6G^a:6kR5S^aAC_FR_^aCT9JBO^aM:R=]_^aVS3:6O^"
    "aWRG>5_^a_0m29g^agNffNg^ahN:in?^an[o2NW^aol`Z9S^b8JZRF[^b:Raii[^bFj]fR[^"
    "bG`GZ2C^bW?U:27^bp4>ZFS^bgk1Ue[^bh;Heb7^c97<N6?^cFWkaf;^cUCAAe[^cbPfn6G^"
    "dB[Pia[^dFlmZ1K^dL:h^6K^dRQGN:O^dZoAF5g^dcI5F2[^dkfo:EC^e03`Ue_^e9S8InK^"
    "e<bbfEO^eP7IN>K^e]L0AmW^e^0Lb2K^ec6CB2O^ed5WEig^ed9]:2C^efkH1fC^eiBc:QO^"
    "ekT=65W^eo6Vb6K^f426jNg^f4pTVEo^f51JmnC^f<P0b5S^fDmjVBW^fEm>Yf7^fJd?mmW^"
    "fTCW]b?^fV[2fMO^fcbe=n3^fhWNb:W^g4^Xj1g^g8<OV5S^gA[gIfG^gD3BRQO^gEZLV:C^"
    "geT_Ai[^go475jG^h1KR:QK^hBVGMYc^hO87mnG^hpLF]bG^h^cafUK^hgRQJ9o^i0o_B2G^"
    "i8J?B=O^i:?UVN?^i@h96F_^iIF2j=S^iIdVIbC^iL<1RUK^id9?F5K^igWe>Zc^iio@F9W^"
    "j7<f5ZC^j87M9mg^j9TA>UK^j@UG2B_^jAT[5R;^jAX`jBS^jI3@fAC^jQQ:ZB[^jRPN]f3^"
    "jU04jN[^jWGP29W^jYo4R=W^jdU5afC^jflPfUK^jmC[:>K^kAAhn5o^kBHDVJW^kD__^IK^"
    "kR=pZ>O^ko`TBN[^l27oFAS^lSJPRMS^l_P?2EW^lhoVeYk^lkWgZ2G^m0oAQYS^m=RoJ2K^"
    "mDmOF5G^mI_Lj>G^mMKI:Jg^mUiC25S^mVGfMYk^mfe6Z=G^n4;5FR_^nC`69Qk^nDZ]Amo^"
    "nM8W6>[^nN7k9ik^nN<0n:S^nUVPnAK^n^4Jb>[^n_3^ef7^nfRDV9W^no0>NBW^o18EeYk^"
    "oMe9627^oNkTZJW^o^PUQYg^o^`lafC^o`h0VV;^ogomB>K^oop`J27^05eXmnK^08=46EK^"
    "0c=hYjK^0eUCbIK^0g5]EZK^1CHRV1W^1PV8EVG^1RmSNAK^1aQl1FO^2@Ec6EO^2K@oAag^"
    "2O3bJRW^2Y[g>:S^2^91nEG^2b9a29O^2gXI]V7^2jWZfNg^335T^9S^3;SNRJ_^3KQAV5W^"
    "3U0YIR?^3ZHI:27^3kD<eb3^48iQBEW^4<@0R6;^4BHi5R7^4Kc[]ic^4oa8]R3^599n1ak^"
    "59@PRJ[^5M<AYj3^5MTGVR[^5S1jZ6O^5]9HIFK^5^85F=g^5noc>9O^6JQX5N3^6SlJ]Yo^"
    "6hDfjJS^6n]165W^77:jnF_^77igaR3^78>DfFC^7?Xdb9O^7ADZIZ7^7H6^VB[^7U]6VFW^"
    "7eB7IR7^7npj5^7^7naO>:S^87gLj5c^8C5FBJW^8Hc@V6C^8RZG5V3^8p9^jFc^90MUn>[^"
    "9IMII]k^9IQnV2W^9]eeVN[^9_U:ab7^9ipXQQk^:9AYFIC^:D0m66[^:Lci^IG^:W4h9e[^"
    ":dBMj2O^;8VDnNW^;:EZ5Z?^;;@A>5W^;C^;2B[^;DM7eeg^;D]O5^7^;DaTjFC^;H;EajG^"
    ";L<4jEC^;QZ]V6S^;TYn^B[^;]7hR=W^<1eGQe[^<DJ]263^<EQ8VRW^<TlX^UC^<UFPZ6K^"
    "<_=W=i[^<hpnn2S^=2iHBRW^=LUfeiW^=enBZ1o^>9n6Qi_^>CMNEfS^>EdiJIC^>H:I>1[^"
    ">JS<:=o^>PT=>>c^>Z]lYVG^>gFF=e[^?0e]mjK^?3=96IK^?PAK::S^?T^Uj5O^?X_DnAS^"
    "?^=mYjO^?`UHbIK^?a=>bB[^?i[8Z=S^@292NFW^@KV=EfC^@MmXNMG^@Pmm623^@ai`a^;^"
    "@iDg2:K^A2eTN67^A8nM1bG^A;Eh6EK^AVa[fR[^AfFpYfK^Ah^7bIG^BD9kR^g^BL?_N:O^"
    "BS^lEVG^BT]YB9g^BV6GNIG^CCNW:EK^CLlAImc^CQ0@227^Cpd[>:S^C]h55n?^CaAenEO^"
    "CeBU29W^Cm`NjNc^D0ffbES^D6>H^9O^D>pBRF[^DNZ5ZAS^D]Q=>27^Dg4pmmg^DnM0eek^"
    "E<2EF9W^E?HdR6?^EEQ]5Z3^EkK4=n7^F2ilaZ3^FP];VJW^F`B<MJ3^Fa<cQa_^G28W>9K^"
    "GMZL5Yk^GVLI6>K^H1ee:5_^H3BY:MO^H:C^nF_^H;2[aYc^H;G8f>G^H=J6ii[^HBaXb=O^"
    "HK?RZB[^HL86:N[^HQ5gn5_^HS]LN=S^HV6?N>3^I1jC>:S^I;0@n=c^I<2=J:C^IF>:BJW^"
    "IKl4V:G^I_BRjB_^J3VInN_^JLZbV6S^JO2=^AS^J`nYZN[^Jgc5UjO^JleLQR7^K6B3B:G^"
    "K:32B2S^K<JMFQ?^K>_m:5S^KG9a:Bc^KNFiBN[^KZ=p=i_^KgKAj2O^Kib]2AK^L;_8nN[^"
    "L=NN5Z3^L>I5>1[^LFfo6>W^LGUkim_^LGfC5^3^LGjHj>C^LODhjEC^LTcQV2W^LWbb^B[^"
    "L`@pV=S^Lh^VJB_^M4n;Qi[^MANFN:K^MDS<JEK^MGSQ25o^MHYlZRW^MX:NF9c^MXOD^6K^"
    "MbFK>1[^MiK8En7^N1kL2ES^Ng4:b:K^O=6jV1c^OHm]NIC^OJDPARC^OS]1>>c^O]f`YVK^"
    "OnP=Z:W^P2V1]mg^P3nR1bK^PSJ?:>S^PTMY2:G^PWgIjAK^P[h8n=K^PaFa]bK^Pc^<bEO^"
    "PdF2fFc^PlclZ9O^Q5AfNB[^QN_1EbC^QQ6LNEK^QT6a:27^Qe2TaV7^R2WiB5W^R5nHN67^"
    "R<7A1^C^R>Np:EK^RYjOfZ_^R`UE6J[^RiOP]b?^RkfkfMC^RlPCf6G^S3LnJAW^SC<K^9g^"
    "SGB_R^c^SVg`IR?^SWfMB5[^SY?;NMC^SfJefJK^Sh^;:5S^T4Zo>JW^T;3M]j7^TFWK:IK^"
    "T_mO>:O^Ta0i66K^ThKI65W^U0iBjNg^U1X?]^;^U1hVmf?^U1lpb:K^U3oZfAK^U9G<^9S^"
    "UAe6VFW^UJC0J=[^UOKNRFS^U]YpRIK^U`Z1>23^Ub1BR2?^V1Udimg^V8]JJ5o^VBQXR:?^"
    "W62`aYo^WSMi^6;^WcK0MF7^X5AK>5S^X5EQ29g^XJSW1b;^XPc@9Yg^XffLF5[^XmT9=b7^"
    "Y4nY:5W^Y=LRn:W^Y>;Oa]k^Y>Kg1^7^YEjLfAG^YNHFZB_^YVf@NAW^YkS_M]g^Z>94n9c^"
    "ZAVkZ9_^ZO4hZ>O^ZXko9]c^ZbKFjF_^[6_=nJ[^[FD>e]g^[OcVV2W^[R;1^ES^[efbaUk^"
    "[mRFAeo^p3pNMac^p9JgF:S^p=;fB:S^p?SAJMC^pAha:9g^pJBU:>g^pRdTf1_^pS?2MV7^"
    "pTLDUZW^ppWgaj7^pjT5mnO^plkQ2EO^]:7IB1k^]@WB9F7^]AQiB1[^]CVc=ak^]H3d29_^"
    "]Ioc6>W^]RMpjIG^]WlEUnS^]ZC`^AO^]ZkVb>[^]cIPV=S^]kgJJBW^]moQeZ7^^EDUAnS^"
    "^Gp0JIK^^JpE223^^[GaMV3^^[X8]jG^^lSlJ27^_2pdmnO^_54@6EK^_H`19V7^_`54YnG^"
    "_bLO^EO^`@?^V5o^`En7J2O^`IZW>Ek^`MMDAVG^`NL1>5c^`VeeB:_^`mWnB1[^aVS3:2O^"
    "aXTCZ9c^a[0=jAG^a_0m2=g^adOU]^C^agNffJc^aol`Z=O^b8JZRJ[^bHHMV9[^bQgeI^C^"
    "bW?U:27^bh;He^3^bo[4>RW^c5`]B=_^c97<N6;^c?@51^;^c]3CjRW^cc8lnAO^clXD]Z7^"
    "dJKSVR[^dZ0TIN7^dZoAF9_^dkfo:9K^eGHd5]o^e^0Lb>K^ec6CAnO^ed9]:2?^ee<2jNS^"
    "ekT=65W^f426jNg^f4pTVB3^f4a3]Z7^f78NfEO^f<P0b9O^fDmjVB[^fRTBVV_^fb9CI^?^"
    "fcbe=n3^g4^Xj5c^gEZLV6C^gY0jf:_^glS;>2W^hO87n=c^h]YXf:W^hfSdMJ7^hgRQJ=o^"
    "i0QB=mS^i7Y>f:k^i@h96:[^j4[jB6[^j7<f5bG^j87M:1c^j@UG2B[^jADCeac^jAT[5V?^"
    "jAX`jBO^jI3@fEC^jQQ:ZB[^jYo4R=W^jnpSQa_^kAAhn5o^kD__^ES^kR=pZ>O^kp4c9e_^"
    "keT:n:[^l6OnZBW^lRlJZ6[^lkWgYnG^m6eBQio^m<S[F6K^m@DZB2W^mBp5JQC^mMKI:Fg^"
    "mWU8UVK^md=R=ec^mmpin2S^n04E6EO^nC`69Qo^nDZ]Amk^nM8W6>[^nN<0n:K^nQUaf5S^"
    "nUVPnEG^n[59YjO^n]LTbIK^n^4Jb>[^nfRDV=S^no0>NB[^oHMIEnO^oJddJEG^oMe9623^"
    "o^`lafC^o`h0VB;^oop`J23^0200023P06P0063P0R000B3P1200023P13<00B3P13X00>3P"
    "16P00J3P17800F3P1R00023P1RT00>3P1VP00B3P22000:3P3200063P3R00063P@200063P"
    "A2000F3PB2000:3PL2000>3PP200123PP6400j3PP6P01n3PP8X00F3PP900023PP;000>3P"
    "PY000F3PQ0001V3PQ1<01J3PQ1X01>3PQ200163PQ3<01V3PQ4P01b3PQ5801F3PQ640123P"
    "Q7801^3PQ9000:3PQ;00063PQP001N3PQPT01J3PQR001F3PQRT01^3PQTP01>3PQVP01V3P"
    "R2001J3PR8X00J3PR9000:3PS0001:3PS1<01>3PS1X0163PS5801:3PS9000>3PSP001B3P"
    "SPT01N3PSTP01J3PT6400n3PT9000J3PU5801N3PU6400j3PU9000:3PU;000>3PUV401B3P"
    "W9000F3PWT401Z3PX8X00N3PX9000N3PXY000F3PY9000B3PZ8X00N3PZY000R3P[9000B3P"
    "[X<00V3P`2000j3P`9000N3Pa200163Pa5801>3PcP001b3Pi9000B3PiZ<00N3Pj8X00R3P"
    "kP000B3Pl2000N3Pm1<00R3Pm2000N3Po1<00J3PoP00063P0a@00R3P1<000V3P1C@0163P"
    "1O@01R3P1`@00V3P1o000Z3P26@00V3P2O@0163P2Y@00^3P39@00b3P3RP00V3P3]@01:3P"
    "3a000^3P48000B3P5WP00n3P5c`00^3P5hP00V3P6h`00F3P7iP00R3P7o@00V3P87P00J3P"
    "8@P00R3P8DP00^3P8[`00j3P8_@0123P8n000Z3P9N000N3P9U@00f3P9pP00^3P:1`00V3P"
    ":2P00n3P:2`00n3P;2@00N3P<E@00b3P<Q@00^3P>pP00:3P?P001>3P?n001B3P@D@00^3P"
    "@]P00R3PA8P00F3PBC000V3PBH`0163PBK`0123PBW@0163PB^`00Z3PBfP00n3PCcP01V3P"
    "Ch001:3PDR@00R3PDZ`00>3PEE001N3PE`@00f3PFV001>3PHM@00R3PH[`00Z3PHi000^3P"
    "HoP00N3PIH`00Z3PIQP00R3PIWP00^3PJQP00j3PK?`0163PLPP00N3PLWP00j3PLY000N3P"
    "LgP0163PN9@00f3PN?001N3PNSP01F3PNb00163PNmP0163POG000V3POI@00b3POW`00F3P"
    "Oi001J3PQB00123PRQ@00>3PR`P00V3PS9@00B3PSIP01N3PT0`00j3PTN`00b3PU0P00N3P"
    "U3P01J3PU?000j3PUK`01F3PUi@00B3PVQP00j3PV`000^3PWb@00B3PX0`00:3PX=@00^3P"
    "YRP00^3PZ9@00^3P[9P00R3P[G`00b3P[P`00Z3P[b`01F3Pp^000Z3Ppg`0163PplP00N3P"
    "^BP00J3P^DP00f3P^^@01V3P_NP00V3P_T@00^3P`J000^3Pa1@01>3Pb8001j3Pc>@00R3P"
    "c``00^3Pd;`01B3PdV`0163Pdb000R3Pe=000J3PeK`00Z3PeS000b3PeY000F3Pe_P00N3P"
    "en000>3PfN000b3PfpP00j3Pg8000j3Pge`00V3Ph4@0163PhH000F3Phc000F3PiJ@00f3P"
    "iS@00V3PjQ@01R3PkD000b3PkG000>3Pk]@00J3Pl?`00>3PlT`00n3PlY000Z3PlgP00R3P"
    "n2000b3PoB000b3PoPP00j3P0J000V3P0PP01F3P0W000f3P0[000V3P1M`00n3P1Q000R3P"
    "1c@00j3P1g`00j3P29001>3P2FP0163P2MP00f3P2V@00R3P31`00f3P36P00b3P41P00f3P"
    "4E`00j3P4H@00f3P4J000f3P4pP00n3P4o000B3P53`00b3P56P00Z3P5D000j3P5EP00n3P"
    "5P000V3P5S00123P5XP00b3P5f`00j3P5l00123P66@00Z3P6>P00j3P6J`00n3P6Q000^3P"
    "6S000f3P6Y`00b3P6a@00j3P6l@00n3P7BP00f3P7JP00n3P87001B3P8k000j3P8l000b3P"
    "9;@00f3P9YP00b3P9Y`00j3P9oP00^3P:6`01Z3P:[P01F3P:m000f3P;AP00f3P;O001:3P"
    "<?@00f3P<V000b3P<i000Z3P==P0123P=CP00^3P=R`01>3P=S001R3P=`@00f3P=lP00V3P"
    ">8000j3P>]000n3P>mP00F3P?]`01:3P@cP0123P@mP00b3PA[000^3PB9000^3PB=@00b3P"
    "C8@0123PCI@01:3PCWP00J3PC_000n3PCfP00V3PCnP01>3PD5P00j3PD=000n3PDE001F3P"
    "DjP00R3PE2@01V3PEH000f3PEI`00f3PE_@00f3PFG000f3PFM@00Z3PFO@00n3PFe@00f3P"
    "GG`00^3PGW`01:3PG^@00j3PGj@01V3PHZ@00^3PIj@00n3PJQ000f3PJX@00j3PKD000j3P"
    "KX`00b3PL6`0163PL;`01:3PLA@00^3PLS000Z3PM7000f3PM@P00V3PMj@00f3PN6P00j3P"
    "N=`01:3PNK@00^3PNZ`00j3PN[@0123PN_P00f3PNiP01B3PNm`00b3PO>@01R3POBP00^3P"
    "OF`0163POX@00b3POc`01R3PPA@00^3PP]@00n3PQG`01:3PQJ@01:3PQK000^3PQO@00f3P"
    "QU`00V3PR3000j3PRc`00J3PRe`00f3PRl`00f3PS7`00V3PS8@00n3PSJP00V3PSL@00j3P"
    "SOP00R3PSU000b3PT0@00N3PT;@01F3PTO000n3PTVP00^3PT``00V3PTcP00^3PTe`00Z3P"
    "Tm`00n3PU0@00N3PUL00123PUM@0123PUS000V3PVEP01B3PVE`00f3PVF`0123PVG`00V3P"
    "VI`00n3PV`P00^3PW5P0123PW7@00^3PW?@00^3PWJ`01R3PWR`00j3PXA@00Z3PXI@00f3P"
    "YL`0123PYi`00n3PZC@00j3PZP@00b3PZiP0123PZi`01:3PZn@00Z3P[Y000V3P[Z@00Z3P"
    "[k`00j3PpiP00b3P]@000j3P]I00163P]]P00n3P^CP00f3P^N000b3P^OP01B3P^X000j3P"
    "^pP00b3P^k000J3P_9`00b3P_DP01:3P_R@00R3P_d`00f3P`4P00n3P`9`01>3P`R00123P"
    "a8P01J3Pa[`00^3PbT`00:3PcI@01:3PcI`00Z3PcoP00b3Pd2001:3Pd7000^3PdDP01>3P"
    "dV@00V3PeH`0163Pe`000^3PejP01F3PelP00b3PfGP00j3PfH@00f3PfQP00b3PfV@00^3P"
    "fn000j3Pg3P00j3PgL000V3Ph1@00:3Ph3P01F3PhY`0123PiRP00b3PiY000Z3PiYP00b3P"
    "ipP0123Pi`@0223PjC`00n3PjJ001:3PjV`00f3Pji000n3Pk1000N3Pl8@00f3Pl:`00Z3P"
    "liP00b3PlkP0123Pm:@00Z3Pme`01>3Pmh`00^3Pn<`0163Pn?P00b3PnYP00^3Po4P00b3P"
    "o5@00j3Po<@0123PoC000^3Po`@00V3PobP01B3Pol@00n3P"
    "",
    "",
    {{
    {610, 964, 169, 1121, 1615, 698, 857, 341, 586, 764,
     600, 383, -12, 443, 315, 655, -256, -274, -398, -743,
     -606, -207, -99, 254, -93, -359, -292, 188, -75, 49,
     42, 0},
    {945, 910, 226, 999, 1256, 897, 1104, 493, 382, 870,
     896, 544, 213, 455, 318, 0, -149, -31, -168, -521,
     -332, -131, -111, 89, 27, -390, -245, 74, 37, 119,
     -21, 0},
    }},
    {{
    {1797, 1520, 1217, 0, 0, 0, 0, 0},
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
