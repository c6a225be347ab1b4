// Made by tests/bench/train_warm_start.sh; do not edit.
// clang-format off
#include "codec/warm_start.h"

namespace unstep::codec::warm {

const std::array<std::uint16_t, kContexts> kCounts = {{
    746, 580, 335, 231, 216, 697, 440, 242, 336, 529, 416, 1498, 127, 194, 313,
}};

const std::string_view kRecords =
    "00001ZC^06aDZEG^072mE]o^0?P6V1[^0?Z4bJO^0B[oiZ?^0DClFJ_^0K`fBMK^0MhXnRW^"
    "0Q[i9m[^0jXX6fo^0oJPBV[^16jdnU;^1<:;nNS^1DHGfZc^1RAJan_^1U0A^EG^1_hPRAS^"
    "1aYkBQG^1iYX]ag^1oRFRbg^2MJI5bC^2X:12Rk^2YPDb5K^2[IpfIS^2_J[B9_^2aZ]ZFS^"
    "2dBJ^Z[^2jclJUG^32hT5Y_^35iU2:c^399Zj:[^39I<EV;^3;18bNK^3<KYRRO^3BKV]a[^"
    "3B[p]jC^3DKoZUC^3P2^NVc^3QR<a^K^3WB`bIO^3pR3bAc^3_H1ifW^3`AR=nC^3hb3^Fc^"
    "3l29Qb;^46A5Ij[^4CH>]jO^4D0C:V[^4Ea[mfW^4KABnFW^4OJRJYC^4ZCc2:K^4b8VbNO^"
    "4c9kVEG^4f3dmZ?^4j8^JIc^5@XgQRK]5L:;mZC^5M8AYZ3^5XhCUb;^5_RMQV?^5lifF^c^"
    "5nh52JW^5o3i1Yo^6Jj7ZEK^6pcTBAC^6^K7eROp6kcL]n3^7@@iBUO^7DYNeRGZ7Jcn:NO^"
    "7LINB=_^7LaP^IO^7QCVM^;^7VJ=F=?^7WaX>V[^7`c]1m_^7aRVjQO^7fA`2EO^7gY7JFO^"
    "7hPTNJ_^80[4i]S^83:<N5_^870EUi[^87h4^YC^88;iMZ;^8<XY1nS^8?Alj9o^8AaAF=O^"
    "8J;D=J?U8McNJ>[^8[8P1VO^8a0PV=[^8k0H5Ug^9<;:UUc^9A[OjVk^9Fa>FMK^9K1T^V_^"
    "9Vj3>1c^9Xk9]m[^9Z1>Z1S^9_AEJ>[^9`[UJES^9ckA>RW^9hINba?^9kc^j6O^:09TnRS^"
    ":23=2a7^::3d^=G^:>K9N1g^:CkoA^g^:DKQJjk^:L;RfMO^:TjDbES^:YbLUYk^:]2lMec^"
    ";1CX5nS^;5SSiIOZ;703IY;^;@P3V6W^;LQgUeg^;MIfR:[^;aJX:1o^;jJOjU?^;jZ;:];^"
    "<3P=Q^[^<5IH=Y[^<61pBEO^<7HBfe;^<9b_R1[^<;j72Rg^<B04bB7^<DQ:f:S^<DXhnNO^"
    "<SBneU[^<TC6bEO^<p3;NMK^<c21NR[^<fQSiU_^<j[QanW^<mS`ZEO^=0C6:UG^=7IYM^3^"
    "=7QGUZ3^=BJ8nBS^=Ea9JB[^=MAPV>[^=UKG>a;^=XAKfJc^=YHniag^=[Q[jMO^=]bF>I_^"
    "=`KlB2S^=`P?FIO^=gXl1ZC^=hPOmfS^=mIMEa_^=mX7ZV_^>7Q6n]?^>=AU5iS^>G`MNFO^"
    ">Hbn^JS^>Li^Ib7^>P1^^]C^>SbNZBc^>XS3Z^c^>^[0f5O^>`C<ZEK^>mjdJBW^?4XWFQK^"
    "?6YVF>W^?G39BNc^?H9Y2NW^?I0R2QG^?K;^9Yg^?OJcF=[^?XP]:J[^?b1IbVS^@9PG1n[^"
    "@>H0j^_^@BCAnUK^@L9aNFW^@Q;YbAG^@_`<FN_^@c36J^g^@gbie]o^@lHeYak^@n0b66k^"
    "@o8mR:W^A0bAUYk^A;k5>F[^A>1>f:W^AGB_bB_^AX@HRQK^A[SamROZAe`K2^c^AhAiUbK^"
    "AmQ<V2W^B0I=nJO^B384fQC^BLQ=AU_^BMZ?fVW^BQI7F9O^BSBj:^_^BS[SUF?^BVS>i]k^"
    "C3i2Jbc^C;;g=nO^CBb>Z9G^CGQ4A^?^CJQY>:W^CTPQ5fS^CXA3nNK^C[kC5BGQCeBU2JW^"
    "CkSUf1S^CmPfZBS^D3K=:JW^D5Z]BQK^D:Zh1RG^DE:iU^;^DVX>V2?^E38K2NW^E7C1]iS^"
    "E<bUQfG^EDYjIVGpEFcDN=C^ELbPB>W^EZcWB^_^E^RN]M_^EkK4=Mk^EoZ9J5W^F2Q_^2K^"
    "F6hfJ9S^F?ZniVG^FFPCR=O^FL8me]g^FOP]ZQC^FPA5]^C^FRhJ:Vg^FZPe:Zc^F]3nmU_^"
    "Fa2ARMS^Fa@iEV3^FbRX2QG^FcZSmQk]FeJOS<g^Fi0ln5K^FjRn:9O^Flc65]_^G0PA6V_^"
    "G6P>AYg^G:JPfIG^GFP8n:[^GFiUFAS^GWhG:Fc^GXj[jk7^Gdc:J5O^GhA`bIK^H5SO9QK^"
    "H6H>=ZO^H9356MG^H9HWUfK^H@aU6YK^HFRcBU?^HORBB5g^HPPT2:[^HSCJjEK^HVXmb=C^"
    "HYCEnRg^H`32VE?^H`b2VR_^HlXd>F_^HnAoN5W^I:9KYi[^I>[Y>^o^IBJ`j9_^IG:^Fbg^"
    "II8;AU_^ISYZmMg^Ij`oB>g^Il``V^S^Imk=IeW^In2bFEC^IncQ1jW^J0Qc5VG^J2I`nBS^"
    "J;YCn>[^J<JVbEO^JF;^mac^JMBpAbC^JPA_2MG^JS3=UUo^JVR4AbC^JXX7n>c^J`H<VF[^"
    "JeB?U^?^Jm`9MYo^K09d1^C^K4X7BS3^K>ZiN:S^KGJ2ZQG^KRQ]jJO^KVXMQV3^KY`HIbW^"
    "Kda@MfS^KfRP2>K^KlXd^R[^L1SH9^G^L9K[M^C^L;YoNQC^LRc;]j[^LU2>aeK^LUP5nYG^"
    "L]aVa^G^L_jDmJW^L`RINRW^La0gRJS^LkhXZYK^M2XC:1k^M6aJ2QC^M@0b1Q[^MA9dVVc^"
    "MBQkAVG]MG;>QZG^MQREj5O^MX@LfIW^MY`Qb5O^MZRm2^k^M`Ql:Zc^Mc2IV9K^MgPW:R_^"
    "Mg`Y9Z;^N5JIi]o^N6ZX:Ng^N91eM]g^N:H3ZU;^N>Kjn>[^N?1166O^NDjPMaS^NFXC6B[^"
    "NYaMffk^N_HNm^G^N_a`6a?^NaH@F=g^Ne;H26S^NfjajZS^O1iO]b?^O6K2Y^C^O:CIQ^;^"
    "OpYIY^C^Oa`jEmS^OiCQEV7^OnZWN>[^P2hCZ9G^P5hLEVS^P>0]:UO^P>:=Ymc^P?RK6;C^"
    "P@0=eQ_^PBcfFEG^PD;=Z:O^PE32IQg^PE8GVUG^PG9=VAK^PJhEF6W^PL0DAESVPSRKeiO^"
    "PYHM9Ig^P`YLiUc^PcbGJQK^PjATZ>[^Q3BSYYc^Q3jX:Z[^Q@SRZN?^QAafiYg^QD:hJ5[^"
    "QGRNEN7^QO3InEW^QS0@REO^QXY@iMcYQ^9V>^_^QcCDZMS^QgSZnV[^Qhia25S^Qjco]QgY"
    "R9k^MjS^R:AHZQG^R=9[^ES^RBB0EeW^RD@?1Yk^RDkU6]?^RFYf6FW^RNQCFU?^RO8ob5O^"
    "RVYk2AG^R[3BB1W^R`8cMek^Rd25^IG^RfH]nRc^S1PK6M7^S5[L2YC^S>J=n=W^SFjYY^?^"
    "SG8djJS^SK8EZFK^SOc_fRW^SaI:ZR[^Sj3lVRW^T:2>YYo^T;9gRJ_^T?RNJES^T@YB>bo^"
    "TF@REiS^TG@ANY?^TGko=f;^TJYhAZ;^TQ3Z]IoUTR[W6FW^TSjI6Y;^TT@RYUc^Ta3A6BC^"
    "Tc8QN9W^TfcY9fK^Tk@=2Z[^U02;Qmg^U0a=6AW^UFiOJ];^UI8?UnS^UN@gnYK^USk_]ZG^"
    "UW3Yj=S^U_c;iMW^U`I^]][^Ul1OUIk^UoPFB9W^V21MR]G^V2@b>6S^V4cR6R_^V5bC>BS^"
    "V7Y[VUK^V9CK=V7]V=2EVIO^VEQ^iR3[VHiN^5O^VIh8REO^VJ:=jR_^VX;jBE_^Vp0Z=ZS^"
    "V`QK66K^VejLnVS^VlJI:]?^VlSdnUC^Vm3L^^S^W0@Tj6W^W0RamYg^W78;fI_^W83:Z>O^"
    "W:1ZJ5o^W<aBjIS^WCh@=bC^WF[b62S^WIXaQYo^WMjMRFW^WPXK:Ao^WQ:]VIG^WSIi]V3^"
    "WcQ?RJ_^Wo:`2QW^X52cJBO^X<P<Qic^X>SP2R[^XCPibMS^XF2fiV?^XKS`BQK^XRhJ2^g^"
    "XXXkB:S^XZH^^MG^XbQFIa[^XmY`6AK^Y8J;J9G^YE3e2QK^YHjkiZ7^YXI;N6[^Y[`?QESV"
    "YiAg6=o^Z21>]ZG^Z51SnVW^ZBZ6Ij7^ZJ3Bf6W^ZLkD>J[^ZXAD=^7^ZYa7:6O^ZYaP^YK^"
    "ZZiY:V[^Z_adNIO^Zmk=Z=S^[0AYeNG[[2k9>MO^[71DB2[^[:`ZREK^[C[Kmn3^[G20Uic^"
    "[GhRfNS^[KKS6^_^[[9;R5K^[];[Aj7^[iCUYnW^[jcZVNS^[lPc:MS^p12WEfK^pFSeBEK^"
    "pO[pE]g^pPj1V:[^pR8cRQO^pW@nEJGSpXJNAic^pd:aARK^pi3kYZ;]]0hhj6K^]4X?:JS^"
    "]8K@F5[^]<80B6S^]>C[6F_^]?8Z^>W^]LY_>ES^]Si7meS^]d[ZbV_^]nH1FIK^^4ADBRS^"
    "^5a7:E;^^:ckAjO^^Ai1U^C^^OAFMmo^^RkmbUO^^SJlZ=W^^V;PJ>S^^h3HQ^O^^l2cnMG^"
    "_4aP=^?^_72kN^W^_82]ZQO^_9Z5=Ug]_?0^BYG^_ES3B5K^_G94N=G^_L2N>Nc^_M2GFR[^"
    "_R9_fEG^_T8nY][^_W0W:IO^_[InJY?^_`2RanW^_eC;6MS^_mY=mIk^`4JMNB[^`5Hb>jk^"
    "`=jdfNS^`>RIaZS^`K@QN6G^`RjDMVO^`Uj]j2_^`c8iRUK^`l0HR9g^`m2ZB:S^`oI9Ab7^"
    "a1cKNBW^a5aL>:_^a8PZAb;^a:0M=nW^a<Q8f9?^a=S8EmW^aB[?:FW^a[9_N^g^a^hg:9k^"
    "acK=V=[^agiK:k7^b0;a=NCYb8[nYNK^b?Rh]]S^bCkORF_^bIBfjZ[^bOQ6>EC^bPJpEnG^"
    "bUR@5B3PbcimF:S^blH;]]c^boYCiVO^c5:>=j?^c<jBfB[^c?K2Z=S^cAhEi^3^cEhK1Uk^"
    "cI@:f1[^cJB?]Qo^cL[jEIg^cMhIZe3^cXQ^B6_^cXkAmUW^c_H0b^k^ch2b^JW^cnBej1S^"
    "d0S>F>;^d0iN5Mo^d;cOfR[^dH`dI^C^dJ3MYZ3^dN1NI^7^dNA9Z:W^dS`ofQG^dX85^UK^"
    "dZkAEZG^dpXdib_^d^ZWVRO^dePcQbO^diC36BW^e0cJBBc^e1XE1eO^e<bhYag^e=Rmb>o^"
    "e>B[UnW^e?3UZIG^eFIS1^K^eMA;ZYG^eMkenJ[^eOIJ5VG^eSCPFMK^e[30^YC^ep0RI>3P"
    "epRhEU[^e][jjZ_^eaRPEQG]f3Sa:Ng^f6BX65S^f793FVg^f92P=V;^f<0mJZS^f=02JV_^"
    "f?POf9G^f@Ahf6K^fB8jV1S^fD2]JV[^fTP2Uf?^fUSk]]g^fZ[D>:W^fpRi5nS^f^a_f:_^"
    "fc:IJFg^fkKgRBO^flJKbQG^fo0DjQO^g<CfJi;^gCPh:^_^gGi:bIK^gIQD>JO^gV:mfFS^"
    "g`891Z3^gaajZ^G^go[[>Nc^hC:66^[^hEiWUZ;^hUI^9iS^hWc?mZ7^hXkD]bO^hZ`CjF?^"
    "h^2QejS^haZMfIG^hc[CfEK^hd2eVVW^hgJKUb3^hj`YRB_^i0JoR9c^i5jSIMopi=;S9IcV"
    "i?1[YbS^i@@MZIS^iD9CJ6W^iI:Dbbk^iKccEb?^iO`YmN7^iPP^JV[^iVQnVM;^iZAoJZc^"
    "iok71MW^j189VZ_^j6`cjZ[^j<ha5Yc^j=[bYmk^jVcNjEC^jWJl6fk^ja3B]f7^ja84BR[^"
    "jc;lFJW^jfPm:bg^kDA4=]_^kIJI:BW^kPj`FJG^kR9RFUO^kVi6fVO^kZ`V6AC^ki`bjV[^"
    "l::8FBG^l<h]mfC^lFh?mio^lJZhVNS^lVAGe^O^lVXDiUg^lW[mfBG^l];HNRg^l`@OB1_^"
    "ldJ5Mmo^lj21M]o^m0@J2:S^m73RV9S^m<K^eJ;^m>8MEYG^m>APn^g^m?ZW^9W^mCI_Mf_^"
    "mIBb5Yo]mPSaiUk^mYJIbR[^mZJ6]Qc^mc8hYYo^mcKUZ]C^mgCDBEO^mjbn>MG^n3Q`:9W^"
    "n6BCjfo^n<kdm][^nHSUeN3ZnfBPZMG^njCO2AS^o1C0:1W^o8R`M^W^o=3QF:G^oBHS>NW^"
    "oI0OJUK^oIYS2^_^oK[ZNMK^opPnfIO^ocAhF6O^od;NbUC^oe;iae[^olXJ29K^00001ZC^"
    "02KbRUO^02[N6A[^03be:RS^0<nQFQO^0RIeEYg^0gID2QS^0heY>YG^0i5gbIK^1<p::]?^"
    "1BAhR1S^1BTQ6VC^1N1[b>W^1i]X]Yk^23?LVYK^2@?gjYK^2AOajno^2GbVbV[^2ICB9Qc["
    "2Nfe1mO^2Ue=BRS^2UlIVAO^2YPDamC^2dBJ^VW^35mU26_^37fGaM_^3;58bR_^3@UIRfk^"
    "3@^_aiO^3B[p]j?^3DG5>]G^3F8_FAO^3NHDVZ_^3Z0a6EK^3_UnJAO^3`AR=n?^3akR:R[^"
    "3g^LfIS^3jFIbQK^4CH>]n_^4F?N6^c^4ZCc2BW^4p0Sba;^4kipUQg]52K_jIS^5;?5nJ[^"
    "5Kgo=Y_^5XlCUbO^5]JhabS^5^KK]jO^5_gKnAK^5b9P6EO^5iTDbEC^5mGFM^C^65Ep25O^"
    "67DJ:RS^6Q8NjV[^6QH]NV[^6QnG]fW^6REefE?^6cCO2J[^6gHi>J[^6iCQ::[^6kcL]n7^"
    "7LINBEg^7S3Z5Ac^7TEIbVW^7[6YEIoW7e`>>YG^7hTTNV[^86h`2m3^886c5UWp88jV^RS^"
    "8>FZR^k^8?Alj9k^8GRVRUO^8P:@JBW^8k4H5VC^8k`]9]W^8le1MB3P92HSJfg^98=>jbc^"
    "9:6G2VW^9;mRm^O^9A[OjZg^9o37:aC^9oD2j]?^:6=ERV[^:9cTnV[^:<=efYK^:<AB]aS^"
    ":>O9N1g^:FKiZR[^:MKfZIK^:TnDbEW^;1GX5jS^;2Qjn^_^;5WSiMKW;7l;2^_^;>4=mNC["
    ";B:DBUK^;M;MNQ;^;O=XAYk^;[nBb^[^;aJX:23^<38SfYC^<>La>VW^<IJ4:RS^<R`4jQO^"
    "<TC6bA[^<TgA^MW^<W4V=V3^<XX1Z:W^<c61NZ[^<m@K6bg^=7IYM][^=7QGUV3^=>:Ino3^"
    "=ChXEQWp=L4FnUK^=SQPnZ_^=WSpZVW^=YZ3BQS^=YjAfIS^=dD`mjW^>1e5QR?^>9[gj:W^"
    ">Kao^MS^>OnKbRW^>k^E9F;[?A1;AfW^?E]>>MO^?Fh>ja?^?UW[^VW^?`k2^Z[^?oHXQNO^"
    "@8kGJVW^@9mdQUo^@BQ`fUO^@G3U2Z_^@MYNjQS^@PYlIV3Z@^gf6]G^@ap3R^_^@eX;2QO^"
    "@gF4=U_^@lLeY]g^@m`8BJS^@mm;^NS^A3Thn6W^A418nAO^A7BO^QK^A?N::BW^ABE9JIS^"
    "AF[onfg^A^FZ6UO^A_[4ZZ[^AkS5fZ[^B3cK>VS^B5kC>IS^B8aUZZ_^B:iK>V[^B>]g:MG^"
    "BKpoBYK^BL5E:QO^B^SBUJG[B^klZJ[^BdOg:IO^BjcKIMkpC4^KF1O^C;ZI^a?^CGQ4AbC^"
    "CYTHNRW^CeXG2Z[^Cf>;:NS^ChYURYK^CkWUfAK^Ck]dV>W^D1eAVQG^DFlVRJW^DVp>UnC^"
    "Dc0GnNW^Dj4V:e7^Dm6mM^W^Do5F2YG^E0d0MQkYE?NcjZ[^EFcDNAC^EXP0:=S^Ec<mNZ[^"
    "EdoaieS^EeY:jNk^F6hfJ9W^F;=a=NG^FFc]jVW^FHaE>VW^FPE5]^C^FRBI:JW^FRH1UV7^"
    "Fa@iEYo^Fc?H>IO^FcZSmR3YFeJOS<g^FeiN>AK^GD^6B6S^GG<GnZc^GMbgaUS^GlT[:JS^"
    "H57`Ffg^H6Ap^]?^HF6k]YW^HORBB1g^HYCEnNg^Hb`BjQS^HijeieO^HlXd>Z_^I87IfUK^"
    "IBJ`j9_^ICJoZMS^IY>@JaC^Ipg>nAO^I^>VBFO^J2M`n>O^J7iNjZ_^J<K5aNCYJ>Rb^]G^"
    "JDHmBFW^JHi6V9K^JHm:B5S^JNM=>QO^JRKNZZW^JS7=UIg^JXX7n>_^J^1h:jk^JdD]6VW^"
    "JeF?UbC^JejJRNg^JhYRnIK^Ji@W:^_^Jmd9M^7^K0=d1^G^K>ZiN>O^KRVZbV[^KXU[Va?^"
    "K]7Ob^c^K_=bmbK^Kmmd1I[^Kok5Z]?^L1SH9Z?^L5hiV]C^L6RgFEO^L=InmV7^LFL5ffk^"
    "LFhP2IO^LI:o5IkZLO1TJV[^M5=5=Y[^M8RZ2UK^MELLne3^MHfDa^S^MJ2?F[3^MY`Qb5[^"
    "N1?7Ne7^N4@<fMS^N91eMYo^N;6Y^V_^N>8kRQS^N?1166[^NDnPMUW^NImjVMS^NQ@@=JGT"
    "NYeMfV_^N]:`a=c^N_LNmbO^O56?VEC^O;pAbNS^O?eUBBW^OAa_F:S^ONRNiQgXONk8Z]G^"
    "OPcM2^_^ORY<FRS^OUH5UJ3WOZ40fFW^OafXbB_^OdnmQZK^OhAW6YG^OhGGnEO^OiGQEVC^"
    "OoU`EM_[P>>=Z1g^PD4`VVW^PJlEF2S^PL0DAIWTPSJfFY?^PXA6jRS^PZh`bZ[^PcbGJIW^"
    "Pm8bnZ[^Q9=KjY?^Q;3pYZK^Q=XX:V[^QAnh2MO^QO6<2R[^QRIcnNc^Q^=V>Z[^QhKlEIo^"
    "Qi3JZZ[^R=2n5bS^RFnj]mO^RG^I69O^RO<oamW^RVE[BZ[^RX_l6UO^RfH]nZc^Rg?62JW^"
    "RimljIO^RneYNUK^S1PK6]3^S7X82o7^S8[fij_^S>J=n9W^SC<K]Z;^SFjYY^7^SNmZ>IO^"
    "SfnpfF[^Si]SbU?^Sj7lVN[^T;=gRJW^T=l^Mj7^TGko=j;^TJYhAYo^TKD1jAO^TRScbIS^"
    "TT@RYQgYTUpImN;ZT]lk1]K^Tcbo6FS^Tl036AK^U0e=6ES^UW3Yj9c^UZpPBfk^V8]JIUW^"
    "VC`0bQS^VIO_BZ_^VIl8RIW^VOIR=]k^VU]>2]?^V`UK6:O^Vo9MFQ;^W3cK^^g^W52hNaC^"
    "W:1ZJ9_^W<aaiMW^W@dj2UO^WEEZbJW^WF_b66W^WPXK:B?^WSMi]V3^W`L;]IkVW`LK6UO^"
    "W`^[6MO^WcJE>]G^WfE<jR;^Wo>`2E[^X20h5eO^XCPibU_^XF6fiN7XXF:<VIS^XW43AQc^"
    "XWW`NMS^Y0PBUN3RY13obIO^Y1OCnFW^Y4>LJES^Y6Oe>RW^YCh:QZC^YU:[VV[^Y]5gN=O^"
    "Y_g2bFW^Yf1OB5K^YiAg69_^ZB^6IfG^ZO^RVB[^Z^1^MN3WZd<YQiC^ZoCB66S^[2ZBVIG^"
    "[71DAbW^[C3h:=K^[C_Kmmo^[UW8bN[^[V<KZQO^[X<On]G^[];[Aj;^[ejYZ=O^[i]Gbbg^"
    "[mHOB=G^p=p;:UK^p@_;JMO^pAF0nUG^pBB@BJS^pNCQEE_YpPn1V6S^pURd2QS^pVm[NF[^"
    "pXJNAi_^pjAQ:^c^]1gc9ZG^]4i:^V_^]5cpZR[^]8jHYA_Q]CEE^AK^]FVpN]?^]IY3aZO^"
    "]LEn2YK^]R1C^=K^]fi8^Z[^]o91ZFW^^5e7:U?^^BD8QQWW^DiT>UO^^I;U:EO^^OAFMmo^"
    "^SJlZAK^^VJ4jUG^^WGd>NW^^W_gMVKp^iTfMF7U^nj7iV;^_4eP=VC^_6JebZ_^_7cCRV[^"
    "_?aNREO^_H7df1O^_L2N>V_^_MSZBVW^_b:[B]G^_c^N>Z_^_djIRBS^_fE`FUO^_ic[YB3P"
    "_lMg^RS^`4g@e]K^`5bGVMO^`O>ViYW^`RcbnUK^`UfM:o7^`]T@bZO^`_KL]^S^`iiLRVW^"
    "`l4HR9c^`oi;ZYG^a1cKNF[^a8HQj9O^a?hbBVW^aB_?:Nc^aJ@TRA[^aR>e2NW^aRQ0je7^"
    "aRalZe3^aT_E:RW^a^lg:9k^akm@=aW^anMmefO^b7BYiUk[bPNpF2_^bPcabV_^bVhdbQS^"
    "bjoCNUK^c17@^QO^c2>l>A[^c8ZnBV_^c9[hRV[^cAhEi^7^cBLbF2[^cE;YBMO^cHRWRUO^"
    "cR39=MO^cajZnRW^ch6b^JW^d0W>F>3^d57afUK^d6:4fRK^d=]<]J7Sd>EA6MO^dH51i^W^"
    "dJ3MYZ7^dJOjEQ[XdN5NIYk^dNA9Z6[^dSeGV^c^dWoiN9S^dZoAEZ?^d]?iZ:S^d^KkRNW^"
    "d^XnnRS^dbn<6^_^doR@^YG^e<fhYYo^e>F[Unc^eFAU>6S^eFMS1^G^ep4RIB3Pep852:S^"
    "eanS>a?^efTEZ[7^f1acjJc^f=g:eRC]fFD7B]?^fLg@^2[^fMa=^a?^fTT2Uj?^f]i42NW^"
    "fd1QaJ;Xg9pg1J3YgBLceV3^gDHlJbk^gQXEfIC^gRfRAFG^gY5gZQO^g`891MWYgcDA>YK^"
    "gh]XJQK^gjQNbbg^h;Z7NUO^hE9mBbg^hJ8obJS^hZ`CjF?^hZ`IJa;^hcpkZVW^hd6eVNW^"
    "hd]ejVW^hgNKU]k^hj9i^k7^hjac5Q_XiKccEZG^iZ:^NV[^j;m]6YK^j=[bYmo^jB1<AFC^"
    "ja7B]bC^jgCf:RW^jjB?=Ik[k7WibUO^kPZo=jW^kT:>Bfg^kU=m=j[^kcL_iV;^kfmOjAS^"
    "l::8FFK^l:e9>V[^lFh?mn;^lPJV2FW^lW_mfBK^l`DOB5c^lbl]Zbc^ldN5N5g^lg;nUJK^"
    "lo5j2AW^m9_<faC^mFZg>bg^mHR9FIO^mI74VRk^mM5OQZK^mc<hY]c^n^MERV_^nkkXMR;^"
    "o2?DBUG^o4><b:S^o9l@ibO^o=7QF:G^oBNH:MO^oBf]nQO^oFPSfMS^oIX6bRW^oK[SVE?^"
    "oPEQnV[^oXUZ6k3^ocAhF6S^00001n3P079b=R3P0E;3YMoW0]D99Qg^0`22BB_^0n;g1R7^"
    "13jiiEoZ15EY=R3^1CNP9ak^1P3NEmc^1mbMAN;^24l?MN;^25JC>A_^26Fnaf;^2VcfeR7^"
    "2YQ_nJ_^35mU1nC^3B[p]f3P3Ppn=V3^3hf3^?C^49]aQ^K^4?LdMF3[4@gS]Qo^4aDKa]O^"
    "4b_;5j7^59DGe]o^5=<gQn[^5@N:1R;^5bEaFR_^6D>FQF?^6KH8]Qk^6p>h]b7^7Jn^mIk^"
    "7LINA]g^7O7GF5k^7lfFEU[^8L04Q]o^8X^<=j3P8f_M]QoZ9>hS9jS^9O`A1Qo^9UOCmMk^"
    "9Vj3=Yc^9e2j9ag^:OFgEV;^:S6=R9K^:VPYQYc^:WkHb5S^;8H@e^?^;OfGNAO^;Z@emF_^"
    ";aJX9N?[;bJQB=W^<2AH=V?^<F_i2>[^<QK6N5g^<[B;Qb;^<a1>MMk^<bKm]Uk^=BheaMk^"
    "=Zhaf:S^=[j>n=O^=b2T1Yk^=gViMn3P=n`[]R3P><am9JGR>Tk2YYo^>XZHjEg^>eb`QNG^"
    ">k>R^A[^>kQcIMg^>llR]R3^?;5IYj3^?GZGej;^?gnpZ9k^?lS8mR?^?mmhAfC^@NJ`EU[^"
    "@R:6VF7^@d^@J9S^@mTNQn;^A:BV=b3PAHCg]Uo^AK1`e^W^A`Lm>2O^AaNJFEk^B1D[1ZK^"
    "B42T:AS^B73]mAkWB8NM=Qo^BXGkj:k^BXkEAYS^C0b^69c^C0kAEZ7^C853QV;^CYlZf2C^"
    "CZn7n=k^CmRAb9_^D;e?mFG^DBo2=Qo^DQgYR6W^DSeb=^7^DdKcJ6;^DjBK^Ag^E<fUR1W^"
    "EBUXMIk^ED0Ga]g^Ea;mBBk^EdM?eQg^F9V_N9g^FCVn1]k^FPE5]b3PF^FG=RCZFcb9J=g^"
    "G6FC>=_^G6OLYfS^GGG:QRK^GM6=MF;WGNPl]Uo^GZ[Zn:S^GpYcYak^Gm?db6O^H36M:I[^"
    "HFm`aUo^HN7S1U_^HORBAmg^Hion^>c^Hoo:Eb?^I<T8R>[^IBJ`j5[^IY1QYN;pIihA]Z3^"
    "IlV:f=[^JRi51b;^JXX7mIk]JZ2g=Uo^JcOpJ:K^K63f>6W^K:O_AI_]K;jNVQK^KRO[En;^"
    "KYYMQZ3^K_=bmn3PKfGU=R3PL2d0:F_^LEH9nBc^LLQl9a_^L]IZ1JK^Lc8piMgpLdSL=R7^"
    "M5J<>9_^M?AAEb7^Md:2MIo^MeTaaf?^MlC]f6G^N>ggZJW^NF1YeaS^Ne;H1f3^O1iO]f3P"
    "O;X1VB[^O?ja=Uo^OX3fYjK^OhkTQ^G^OnZWMEcZP05F]Qo^P>>=Z9S^PhR:eYo^Po[m1Qo^"
    "Q57_>>W^QQSTEn7^R3L9MNS^R9;<IMo[R:Uk]R?^RDL2nB[^RKL[]f;^S4MO25_^S:<QmMk^"
    "S;WAA]c^Sp49EQc^T1=Xmj3^T;=gQYg^T=k`ZN[^TGko=V3PTUm@]QcYTn6F9bG^U>n41VK^"
    "UD]6mF7YUF7f=Yk^UT@]9^3^V>TZAJ3^VE^LQYc^VG9;aio^VaVh=jO^VgV3eV?^WF_b66W^"
    "WINXmVk^WPXK9RC]WSMi]j3PWaO;=]k^Wd=4Emg^XJOnQ^C^XP?1MF7[XQY`]Ug^Xnp<emS^"
    "Y26XaUW^Y3QH65k^YJ6Tej;^YQ@G1V3^YVdpMn3PZ>0PV1[^ZD8eYa[^ZU0SQFK^ZZ_VIIg]"
    "Zp:E]R7^Zm15]mg^[6h:eZG^[MDdF9[^[[`kmIk^[];[Ab;^p6Na:2?^p7P>B9O^p=XSE]c^"
    "ppbAQb7^piPI=j3P]4@H>EO^]7QZ]McZ]FdR29S^]OZ`9jK^]`RN1ZG^]fAPmEgX]gp@=Mg^"
    "^5e7:5_^^CT[n=o^^`94EUo^^gBfQQg^^m`5f=S^_@D?Z9[^_I:Mej7^_k32mR3^`2<e9Mg["
    "`<2lN6G^`=4IVMo^`C3U=^;^`OXSJ9S^`l4HQj3^a1cKMQ_^a3>:aYk^a3mk::c^aLH]F9o^"
    "aS[2aN3^a^lg:>7^b2da1Yc^b5RZ:2C^b6T7BB3^b?Rh]V3PbI8A69[^bMT:9R?Ybe]?YZ3^"
    "c6TmQRC^c<D0IEoYc=^_]Uk^c@1bZ=k^cEhK2Ik^cKgVYb7^cXLTfIS^d6;SaJ7^d<alV>k^"
    "d=EF1Qg^d>`5Af7^dU<^b=_^d_<mEQo^e>F[V:[^e?H8^Eg^eH?DYRKpeK4c=b3PeQlBR9[^"
    "eY64]]k^f6AZB:S^fB6h1bG^fGejmIgpfHed6:[^fI@Z=Uo^fNpLNIg^fi]RAQW^fk8AUj7^"
    "gA]NEb7^gEUn2>g^gHg@QZ3^gNKUmn3PgX:7f>C^g^0`>9c^hH<:6=[^hLWM1JC^hRFOiIk["
    "hSa?=N3^hZ`Cj=g^hdWo=j;^hnO4ER;^i?5[Z:_^iQYeR:S^iSGeMI_^iTbTa]o^iWPMfMW^"
    "j5?Lef7^jNIoN>c^jTI;1]o^j`n9BFW^ja7B]j3Pjo8T=VC]kGAYYnS^kQ0;R=[^kX9GQVC^"
    "k]hJMN7pk_C9]U_^kmL0Yik^lA:a1f;^lGi]62?^lW_meV7^lZMfjBS^l^i`1Uc^l`DOB5S^"
    "m@aGEeo^mW>0f:c^mbYlMNK^mic^YR7^n:ZN]^7^nYd<nA[^nc[B1eo^niJDmMg^nje4=]g^"
    "oCoVf2?^oKAlAI_^oP]^R>[^ocAhF6W^ojKZQYg^00001Z;^0593ej;^0:l;34o^0Ab3nno^"
    "0^`@^6[^0nRUV9K^1Q=XURk^1pj_N5o^24W0B0_^2Oc>66G^2TJbf^_^2_AM>>G^3<gB^6?^"
    "3B[p]j;^3LEQemc^3`AR>9_^49h3K77^4?>0NAO^4bX?nJW^5Vacino^5j81ZA[^64b`>J_^"
    "6Cg96i;^6LT=e:GQ6_1>V9S^6kcL]mk^70Qepn3P77MSZQK^7<:p2CK^7J[X6e?^7Qi]>=_^"
    "7ee]V2G^8?l>Nfg^8FJ2ibc^8pODMg;^8pPU38k^90fKVJ_^99BQQno^9@DZ^:c^9GR>mE;^"
    "9OI3[8k^9P6oVIG^9PKSZ>_^9p^1Vi;^9c^j=j_^9jS969o^;1GX66K^;^Kp^V_^<QI96i;^"
    "<`bJR=k^=CQCj8c^=D<Z2F[^=Ld0^j3^=bp3>ec^=gViMj7^>^Xm[>G^?17INN[^?;_[?77^"
    "?@UXV9O^?pk3Zm7^?]_66;C^?_9j_33^?eK[>no^@3N7>MW^@aPXO33^@hbEk93^A6>:EIC^"
    "A?1U6YS^ADjgnjk^AfjBf3?^Ahd?KCC^Ai6XmAG^BH37B0c^BJ`jF6C^BXcF1A7^BZ?9N:?^"
    "C2D_G:[^C=YHmio^CGA:VeS^CO8@ZRo^CdM9k4o^D8MH333^D@06b:?^DONEiek^DcJF>1_^"
    "Dn2X3CC^EIPV^UC^ER>I24o^E]LW6:C^Ee5]j8g^Eljf>2G^EnHJ^^C^FPE5]io^Fa@iG>_^"
    "G?98MIG^GDDk3:G^GR[cNB[^G]D5?GG^Gb:2VEO^H?CP6GC^HMdL:e?^HU2Q>EW^HWNABaC^"
    "J9Le^1k^JJ[2mLg^JQ96Qlo^K;cSR6C^KZZNA:W^K_=bmf7^Kj9mni;^L>5nFm7^L]2LZm7^"
    "Lh^BnF[^M1pHjIK^MKnLb0g^ML8RN1k^Mk50^9g^N3_0nV[^N?116FW^NFZ7j<g^NNO@>2_^"
    "N`I?K13^O1iO]jC^O;SDf=_^OIWhjm7^OXpbFFW^OnKcN9[^P4@=NF[^Q92[C<g^Qkk9kH[^"
    "R;b0e:GQR`:CV5g^S79P2RW^S>Q]>UK^SMi^EjO^SdQ_^>_^TGko=nG^U6`1mY3^U7odBaC^"
    "UmplN5k^V2=A>AO^VJ3W^Z;^VLYJ^=k^VMBFJpk^VTl:V=C^V`UK66[^W03Z=fO^W;;3kKK^"
    "WMYO^FW^WSMi]Z7^W]7^f9S^W^gpmM?^Wm:hg4o^X:A<FFW^XBAlMM3^XP0=R=W^Z`E<N:O^"
    "ZdU=R8c^ZjmN>no^ZocKUmW^[C_KnAW^[[Me6m7^[b[j>EW^pEMmf@g^pF69^>[^p]cBESC^"
    "p]eQ_8k^piPI=jG^]A>bJm7^]OFU:lk^]QKD=b[^]f2pnIG^]kg6n:S^^9n]F6;^^ILlN6C^"
    "^OAFN1k^^lg;mek^_DUU:i;^_o=i^B[^`>p8jAW^`?m>:;3^`N4dQG3^`ZhOZQc^`[eVFJ_^"
    "a1TWRA[^b?Rh]j7^bTQFbJK^c=3Y6jk^cAiVNZk^cQGeV1k^ceCen1k^dD@D>=g^dfo=V=c^"
    "dgZS^J_^eCdUapo^eE@I>R[^eK4c=j7^ehPS34o^f[S7FBG^fk1FN2K^gNKUmj?^gfOJNno^"
    "hL@?W4o^hPbCb>G^hYU=Vi;^hbTG_??^hgJE65o^in>d62C^j=]3>6;^j>IC7[[^jXV9j7G^"
    "ja7B]mg^kXdZ:Fg^k^X36no^kcN0NBK^ke786i;^kn6B?77^l2l?Uag^lA3en>S^lFh?n1W^"
    "lQPQ_;;^ldN5N2;^m5pB]lk^mHSWVAW^nJ?2^1c^ngbd^jC^ni;Q25k^o=7QF:O^oB@U>Jc^"
    "oLU`QjK^okL[A>g^00001eo^00Y:i:GR0WVm6io^0ZS6bAK^1W<AG8k^1l@A>]G^2<TS1BW["
    "2X@5JbO^2^^>:A[^2k7RAmO^3B[p_:O^40<kbNo^498pbK3^4CH>^1O^4Q<B1nS^4daU^B7^"
    "5APY:e;^6LKeNG7^7?HEbno^83oTb53^8Dp@Ahk^8I:9Bjo^8TZQo;;^8cepZYO^8df7bVW^"
    "94RH:Ig^98KKN>O^9JaJZRc^9h23N9c^:O1D1j[^:TjIBbg^:VYYfm7^:`5[>J_^:i1?:2C^"
    ";1GX66S^;@BX:MO^;S`f6:g^<0Pbf1S^<bnS^2[^<i3fV13^<jJC:Rc^<lb^5i3^=4]1n=W^"
    "=FG6EA_Q=O0IR;3^=QL=6=k^=_S[g;;^=boYAnS^>2MM^=S^>5986m7^>?pOEik^@<BpBYW^"
    "@K?^^^g^@V<g^0o^@]B_6Bk^A55_FVk^A6>knfg^ABQdnjk^AOS9^6S^AcC5:U?^Ai6Xma[^"
    "B8ZYfAW^B@_]iB[^BVon^o7^C9ghZ5W^CJUY>6[^DbIl6FW^E0lTeS3^E6bWJeO^E9RdF:g^"
    "EaMCFGG^EnE=R73^F4DiR:[^F`Tm^bg^FcB2B5G^FgVN^:O^GIKW:Jc^G^?Nn1W^G^hYe:GT"
    "H;R^^AW^HB0mB:g^HhoRZ>S^I7;DbFg^IegMZMC^JJ[2n5[^JZ?3fA[^K0k;[:G^K2Y[B]W^"
    "K;@DN=[^K_=bo??^L1W]YmK^LS14ZQk^L^BAEPk^Ljb>ZfG^M<YHJE_^MahDZaC^Mg[hNB?^"
    "MiVm>>c^MjGRjm7^O1iO^1o^O2jmXj3PO8M8:EO^O>]T_4o^OE;=N:_^OJ^h]=[]Q3BSZ6C^"
    "Q5Gfk5g^Q@J`n7;^QZDMV6K^QhKlG;;^R=BeRYK^RDT9]i7^Rd?0313^Spd^NIO^S^`AbQ?^"
    "SaDff6k^TLF>aMC^U<K@N>g^UFlIJFS^UG]Y]n?^UZN8V:W^UdL];13^VOVJ>>g^V`pl20g^"
    "WSMi]j7^W[W;:eG^X0<m:A[^X@iXZm3^XQVD:ik^YWF7j=K^Ya?Q^Bo^Z;]o:RK^ZU<`613^"
    "[0N_>6?^[<h3F1O^[D5?am7^[PeknBc^[pVVR:_^[g7_N2O^p>UXV2?^]`a[Z^c^^=oIVFW^"
    "^a]d2Z_^_9cL?6[^_P[^Z2g^_]EQF=G^_em]JV_^_ib=ZQ3^`E`5eIG^`HD1RF[^`VLaEQ7^"
    "`[iE>NG^`aQh:=c^alQ=b9g^b9bTR2K^bCSTnG?^bVK;:V[^bhJ:k4o^c6a:6<k^cMMAkKK^"
    "cN3N1jG^cR39>67^cVXhb6K^cZ<JZm?^cfBRam3^dKbAOCC^dLQ`B0g^dU@_^9G^dY1]V]S^"
    "doS:nM[^e9<D1eg^e>S?9IC^eFImC4o^eFMS263^eGDDk:?^eUkGJEc^eXW1g4o^fF93NFW^"
    "fFiY:e?^fX>Wj^_^f]VlVBk^fhOGVB_^gR_>>;;^gT?;26k^h9;<jAg^hgmHaM?^iV[KBno^"
    "iZ7Hb2g^iplg>J_^ib[1bA;^j6d>f:K^jJK:en3^jOEUQ=[WjbOE:aC^jiU<R8c^k1:oFRk^"
    "k<9=Eeg^k>CbR5K^khGM:MC^l:U]b=7^l;F=E]K^le@M:]C^lfi6NZS^lmF[Njk^mB]5iOC^"
    "mHS8NR?^mP1U^^_^mXmF^V[^nA=7a^_^nYFRmf?^nhB:Jbc^nkS4Ai?^o52SFIC^oA]HZ1S^"
    "op0`>2o^oaWLJ>S^00001jG^01b19mW^09Be^FO^0B0`R5K^0D:J:NS^0S^0FIG^0V59:6G^"
    "0XE@R=W^0`GFImS^0cDR6AK^0hQ9NJo^0oMmNG;^13SAN=C^14^[QN3^15pk6FW^1<`aIiS^"
    "1>Jej9O^1E@QBAW^1HmWae_^1MBW:1c^1N?d1NG^1N[PI^[^1QnXn>S^1Tg31Uc^1W@n>YG^"
    "1]Fbj2G^1^p`UjC^1_i;6EO^1fA<MV;^1fK`6A[^1g?L2F_^1nCBEQk^26c2BAW^2>e8:5c^"
    "2A4IieK^2CQ9inS^2CcJZJg^2DY=fUG^2NiCj6S^2P?AUn;^2Wc]MV;^2]JSfJk^2dEFEbC^"
    "2l4EfA[^2lGL>9K^2m]Ij9o^2ncFVRk^31DeiJS^353ZenK^35_OaiW^35mU2:K^3;QNAj?^"
    "3AabQf7^3B[p]j;^3IchImg^3MmNUm[^3TCTfBW^3XoVZIW^3]im>I?^3_?jjU;^3cg;6Q?^"
    "3gB0b5[^3k=KnNc^42KemaW^4:nQJJ[^4GJHAek^4OLN9aO^4PbKf=g^4UIp2EO^4W`db2;^"
    "4XdQ^1_^4Z0l>=S^4]_`j^k^4j<e6Jg^519Y9jg^57HVbJG^58li>9O^5@6QV1S^5@no6=o^"
    "5APOG??^5JYCI^7^5PG<66c^5aTfbAG^5h7KbIS^5hk7^FW^5jOJ9f?^5nh_2Zc^6@Pcb5g^"
    "6D52f1S^6EK0R9K^6EO6FFg^6Id5b:O^6PToR2G^6Qjm=bC^6RG=J0c^6YBjFFO^6YOI5R;^"
    "6Ym35mk^6]nl:U7^6_6?N>c^6cIM^N[^6dQQ:R?^6n37j9K^6oI5VMG^70O2BN_^75WSbIC^"
    "76_FR2O^76mQN=K^7==9in;^7Ai;^BS^7CMN9b7^7G6VIMoZ7OY:=f_^7TFNRQG^7_UXf9W^"
    "7`kVRE_^7eRf^EG^7li7ZBW^8ABcf6c^8F3C^VW^8PZOaeO^8Q89b9_^8RIEj6_^8W5GZMS^"
    "8Xg9BYC^8YLPN2[^8_KLR^_^8khPbB_^90QVm^G^92eDb>k^9R2g^B_^9_7M^]G^9b47mbG^"
    "9jVcFJc^:3D^>=W^:7XIFG7^:>O9N5k^:G6p:MK^:G:b26W^:HAR6bo^:KOaJ>W^:R@[>6C^"
    ":SVXifG^:YVbB=o^:[X^b1o^:_ZWbU;^:jPh2?O^:o^cV9O^;14a>9G^;2:]nNg^;8K2:2G^"
    ";96g:1C^;DV^>:_^;E99ef7^;QDej2[^;pFmnIK^;bWB>E_^;g>RJAK^;nTcF:O^;o?SRFW^"
    ";o@XAmk^<=eC:IG^<BnOR:c^<Xa3FI_^<eO:n:[^=2=BYfK^=ZhafJc^=lBO2Vc^>B_E1V[^"
    ">JJ`5ak^>SlFf6K^>[BMn>7^>aFCNAO^>bMVbBk^>e0U2GG^>hpTJR[^>iHIEa_^?1JO>9W^"
    "?2`LjIC^?3fIVB[^?5Jp21c^?>]n2BK^?FBIj:[^?RhdJ=G^@0@Nn:O^@T<JbV;^@U`]>>K^"
    "@ZL^nQW^@o8V2m7^A2S0Z2;^A9Hp22C^AVfdFIG^A[N4R=7^ApPeZe?^A^hjB9O^AeKOAb3^"
    "Amn:^c7^BHIEFM?^BPKK>5S^Bpn9ZFk^BaeTYf?^Bd9BN>g^BigZQm[^BjH@6R_^C36:j=g^"
    "C4L8VIG^C5R5B:O^C6d:>6S^C76G^5c^C9kfB9O^CAml:EC^CB@<iio^CFl>^BW^CGn5V2_^"
    "CSH5Ub7^C[J;M][^CjUi^=O^CkNG>5o^D1l:Z:S^D3PM5j7^D<c_6BO^DDjVQic^DLlpIe[^"
    "DT6RR]G^DVp>VBS^DWLHj6S^D^>;RY?^D`8WN:K^Dd:PR5S^DnF@26S^DnTJnAK^E6M7MN3^"
    "E7ZJf1?^ENEX9ZO^EP7YEMoYEXRP2=G^E`6kj5[^E`TUj5W^Eh91bAO^EnSiZ0k^EoYfFVk^"
    "F4BM9jc^F8Ga:A;^F9S;=Ec^F:QJbFK^FAUA69O^FJ50nAS^FR76f5_^FS4C]RK^FY[R]aS^"
    "F^YeBNo^F`6JUaK^Fedn6>k^Fi67Q_?^Fk5p9RG^G37b1Q_^G67d>IG^G7=`j:[^GCYWb5_^"
    "GCkhUfG^GHEYUnO^GHWjFBc^GIYa>Bo^GS]cV6O^GpX=9]o^H1;kj=S^H1o4FBW^H3WfB:G^"
    "H69EUV[^H9h:QfO^HE@DQb?^HFVB=j7^HNXH5ik^HORBB9_^HUb>>]C^H]d6FEK^HadC::S^"
    "Hb^LjIC^HcD1bm3^Hd4JRIC^Hef<>9_^HkJ[Mj;^I01kZFW^I88c9Z;^IBJ`j9c^IL>gmeg^"
    "IT@mf9K^IUVkRES^IZ>;^EO^I]Y1J5_^J1ER2N_^J5n8f2c^J=aHj5_^J?XY6JW^JEcNb5_^"
    "JSbbR9c^J`EPnFk^JgPYbNo^Jm_WJFG^JoCief;^K7cOj=G^K8iLV2_^KHiRR5S^KJ?P=i[^"
    "KJCV2F_^KKELjW3^KNXUNBS^KUIO>:G^KV_LijG^K[F]5fO^KbcKfI7^KiF0f>7^L2gWVEK^"
    "L5CQn>S^L:F>QFK[L:L3NI?^L;Sf>6O^L;b1:QC^L;kcNa7^L<@NbJ[^LFl09bO^LHAmej?^"
    "Lb7]RJg^LcOnf2C^LdJ8R9W^Le`6>EG^LknTIiS^Lm6G9^K^M1]WF>?^M8l1AQ[^M9dNab;^"
    "MUNoN5O^MWBW:AS^M[igFEK^M][Xn9O^Mf[UI>SSMgZ6fg3^N31=ZB[^N5F6YUk^N7YdMng^"
    "N=;E6?K^NADD^Vk^NEM=n>[^Nb1<Un_^Nc`fRAo^NfhWUfG^Ni<EN[3^NoKC2FG^O9O;R=O^"
    "OKk;f1S^OKoAZ>[^OM18RS3^OPDA6BW^OQ96>=g^ORbIV6c^OW5:j:C^OXK8UfG^OdO7NE3^"
    "Ok1pRF7^P4SCB9O^P6]06J[^P6o=VBW^P8SP65c^P=?Qf2?^P>>=Z5c^PHW[ebS^PImYQf;^"
    "PJf4ejo^PJlEF:G^PZk`:Z[^Pa;MZEG^Pe;ZN:G^Pf5d>=[^PgKajAc^Pi=SRAW^Pnb2e^S^"
    "Q;P:Mj;^QBYbfAS^QFQe>QS^QGbo=nc^QQMONJ[^Q]US2I[^QiEbNo3^R4piF>[^R9EP:>_^"
    "RG8iZ>c^RI:f663^RJL2>B[^ROP9N:o^RZAi:97^RcphAao^RhTCA^3^S16n^FO^S9diR9S^"
    "S;:g>5S^SMVgQeS^SNpd>B_^SQolb:[^SX`fR:C^SZ6d=f7^SgB6N6k^Sl]H:Ek^SmQ46FO^"
    "SofBYa;^T6>nj5S^T8ZiB>S^T:?;^5g^TJCGQn[^TNJLnbg^TS[K1mg^TW]D6Ec^Ti7MRAO^"
    "U0M^M^O^U=;f9b?^UY0jNZG^U_A>ZIO^V81Y2BS^VHdUBBo^VL7]fBG^V[[D2EG^V`UK6>K^"
    "Vc]Ij5g^Vo_pY^7^W2bZFJW^W:1ZJAc^WF_b66S^WM=e2po^WSMi]bC^WU?jj1W^Wg]2BM_^"
    "Whmb:?3^WnI3fEK^Wnp:=e_^X7jZV5W^X:FTn:S^X>`EnAO^XB<2j^_^XFbKfEG^XKo3:Jg^"
    "XX<UAb;^XYHobQC^X`>[9mK^Xd4Cn;7^XdWb>N_^Y0Bfj9[^Y29J9f[^Y6`ZF>C^Y8Dlaag^"
    "Y:2@E:;^Y>gQab3^YI_6=eo^YQa<5]c^Z3:_^>S^Z3HjZAK^Z9]D^FW^Z;AW9Yk^ZJP@nVo^"
    "ZS?12QO^ZpeZ2fg^Z]Fo^AG^Zd]@Z6O^ZdkKVAO^ZfK;W0o^Zj0EaaC^ZkkZUac^ZlmQN9W^"
    "[1KHAbC^[4NF2J[^[5::m]S^[?EjNJG^[J=i_33^[NiPZEK^[SP`fEO^[ScKBe;^[^P2J=C^"
    "[aYSNB_^[iR:NIO^[jYMb?3^[n^abI?^[oj;eQk^p04_NIC^p7lA]U_^p<2@V:[^pIKDEVW^"
    "pMZ^fNg^pP2SIQ_^pQaIN6S^pXRCB6K^paLpeb3^piNb]U_^pjpU=J3[pk8g:5[^]2YBpnKS"
    "]3e5b2c^]60KV1c^]:meARW^]>pZ=jK^]@S=Mb;^]J4d=f;^]KJaij3^]Ro=aN;^]gRlR1O^"
    "]h8QNi3^]hhj>MC^^0?;9bC^^4fKFBS^^5e7:9[^^68?JQ3^^;I0FFW^^<mBe^7^^AT`bE;^"
    "^L;lZ:_^^OAFMmo^^Q3GYm_^^Y5MRIC^^ZKK>MO^^_2[J=K^^bMQ65_^^fHlB>[^_373mnS^"
    "_6:1^J[^_:bXRFc^_BUhUmg^_H@05e;^_JWnN5S^_Kml:=c^_PU<FES^_k=f:IC^_lE9NNk^"
    "`2T76>G^`48IQi[^`6LXVBW^`B7]B=o^`OFJN>W^`[SlUb?^`abJb:?^`kjI5nW^`l4HR63^"
    "a5PaN:[^a;pD61o^a?@S:AC^a@HEj6K^a@VPf=G^aB>i5f;^aGlab6?^aK`Of2G^aM6MQjG^"
    "aTZiIV;^aU8SImo^aUe;nJW^a^lg:>;^a`P]J67^adDAZEK^ai>X>5O^ajTUjMC^b0c469G^"
    "b1jfenG^b=4p2FW^b>XnMak^bC=KZR[^bZCO:5[^bZa9:5[^bp76fA[^b`^G2AO^beEW>=K^"
    "bh4WnFc^c4b_Z:[^c7e]F>c^c<ND:O3^cAiUe]O^cKf05^K^cLCZ65_^cZBmf5c^ck]7AbK^"
    "cn0e:Rk^dQ26::O^dRZX:^c^dU8`bB_^dZBn2]?^d]?XAfK^d]o[b=k^dcN6N67^dnP>R5W^"
    "e1XSjAc^e7<M62S^e8do62c^e9Gbj9O^e=Gob5o^e>F[VFO^eCjTab7^eF[A^:S^eIXMI]k^"
    "eK4c>2;^eNb9=b7^eVC629G^eVFU5^C^eVd?61o^eZf8:EK^eb<I2>[^eeomFEC^ejjCj=W^"
    "el@AVMC^f3VRN2O^f>`G^J_^f?L<YU[^f@DZ9b3^fg1BjAO^fi`CZ:_^g6NKB6K^g>9of>g^"
    "gO@QfFW^g[nYQiW^g_6Hem7^gnU=NEG^hR]ab6O^hWlW>R[^hZ`CjBC^h^kCijG^he9b62S^"
    "i0;j:5[^i8h8anS^i;3NUmS^iEV@Mao^iKD95ek^iO7g::K^iX2@]fW^ipQcbIK^ich4^>_^"
    "idSiYeo^ig`VB:[^ilUoR=c^imkm>EG^j4@_F^_^j5B>9nG^j@L3FJc^jB0Eef3^j]eJ6ES^"
    "jkKoAj[^k8:6mnG^kC1[J2C^kPl=R>W^kW32Q^;^k`Oc^EO^l0@i6I[^l4T<Eb7^l::8FJW^"
    "lFh?n5k^lR2D^MC^lTIMN6G^lZ4JV9O^l`DOAmo^lfeMb6g^lkNT1Z?^m1gUfA;^m3=SR=G^"
    "m3PYie[^m:SdMjK^m<_:B1S^m?;4Z>O^m?bYfZ[^mCTeZEK^mGAl5ao^mKVkR9W^mLodab_^"
    "mPcRf:G^m]14mb3^m^=ONIO^me3:f5W^meS`JJ_^miLAjNc^moWXjAO^n57FV=K^n6mif2C^"
    "n=9LMiW^nB7_2Vk^nCp1Mao^nE]2Vfk^nNSUif7^nVU[aY[^nfYgR5o^njHZ>AK^nm7Zn>c^"
    "nn[mIj3^o35BBjk^o7o?JBW^o8=JF5_^o=7QF>_^o@66eac^oH8<^9[^oLAbj5[^oRWi>6W^"
    "oVS`ZIc^oYI[fUG^o`g2>UG^ob;OJEG^ocAhF:W^oi_kBQC^00001b7^08K8^E_^0FQ]9Bg^"
    "0O6>W33^0`aG6R[^0eRh6:S^1X0SIjG^1`[3RQ?^1`daZRW^1fJ6JBW^28?3YaK^2>:jEjK^"
    "2Ji21ag^2LA=JI[^2SWWmnO^2[:;J@k^2c9Z:JG^2j9E6F_^303M6NW^35K7^N_^35mU2:;^"
    "3;]nnUO^3B[p]mg^3Q3>JZg^3]aF65c^3e5=^A;^49Q8MbW^4@lej0c^4EBgJEW^4Vjk6E_^"
    "4^_6]eg^4iO4jM?^55aZMf?^561;if3^5<mpZNS^5NpC2AS^5O=ibIK^5YIQbjg^5`LpF2;^"
    "5`SAUb?^5e^0:=[^5h8RF1[^5hZ95^3^5mAIB2G^62mFR:W^66<YJMS^6LM5N9C^6P7Abjk^"
    "6SE:m^?^6XVNbI_^6]8`JF_^6eiDaac^6kcL]io^6ndENBS^7@l]:V_^7BE9iBW^7Ofp:IS^"
    "82C6EiS^89T4f9c^8XJI^5O^8^F@J23^8e;TnEc^8e?Zb:_^8lLSNEk^90ZXV;?^9;aGjB[^"
    "9IPl^>g^9KBhFEc^9UVMb:S^9elafR_^9n]F9bO^:1>TNFS^:BS5^IS^:E?3F]3^:WkHb9o^"
    ":[oE1ac^:^[BZAC^:hRmnEo^:hpYVbk^;1GX66C^;>jLaeS^;Um0Qj;^;V<QmI?^;ZRSMm_^"
    ";oI?fQo^<24_:6W^<<7GMj3^<DUIFB[^<EiF>9[^<HeO9M_^<Qb`f5[^<RDn:Jg^<VGoNEW^"
    "<X?662_^<dm=aZG^<i4f1mg^<k?0:1O^<n`cBN_^=3GTf2C^=8adfA_^=@5pQf7^=Zhaf>S^"
    "=a83>NW^=gOD2=K^=gViMj;^>022>IC^>Y_Jj5c^?K?^9j7^?LWiR=c^?[8oRFc^@5acenG^"
    "@7TdZJ_^@A]lbRW^@BOkQnC^@Ch6jMO^@DBlFB3^@K:KZho^@QIjRJO^@]_;Z5g^@^82>1g^"
    "@b^KbAS^@jPbjEO^@m21>>G^AFZkEaS^ASW@62K^Aemc2>_^B3lO>0c^B68FR2C^B6bo6JW^"
    "BCXp:K?^BT;f65_^Bcm0nN_^Be?o>:S^Bf4pB=[^Bi0e=]c^Bi[M^2_^C@Hf6N[^CAJC>I[^"
    "CDXkim[^CSnM2AW^CXm:jI_^CYVhF=K^CZfRQn3^C`A2Uf7^D;i9Amg^D>=lb>[^DJl4Mb3^"
    "DP=HBEO^DVp>VFS^DcJF>1_^Dm2fZ:S^E9j`nEc^E<fUQic^ES==YjW^ET;]FJ[^Ela2JJW^"
    "Elc?VR;^EmVkVAW^FI?2BEW^FJ>DZE[^FUm9j>O^Fp@1:A[^FpbNNEW^FbJiamc^FcZSmfC^"
    "GpD19^O^HORBB=K^HVCpUQC^HhnQV:C^I<N3UU;^IBJ`jIS^IEKEB2K^IF@2F9[^IFG^1eg^"
    "II<;ALg^IR9LnE?^IXZaFIG^I^2gW:K^IddAn9S^IeVOjEC^IkUpB5K^IlNUIj7^J3^@mjO^"
    "J98PnIO^J@LHYag^JBl<^N_^JOeoVBW^JVlO2BS^K0H^F=S^K7pV1eo^K:1IRBS^K=6f2:W^"
    "KRO[F2G^KZ672A[^K_=bmik^L4G3JFK^LLnUZEc^L]Nl9ho^M5=S:>[^M5BVajG^M68OnFc^"
    "MD>c2A[^MGM1>@g^MK`>6Nk^M[Gj9n[^N<kBn>_^NBeJnBK^NJ52RMK^NgV4]bG^O;Sk^9[^"
    "O=@M28c^OeV[F>K^P2Dc2EK^P@J52fG^PG;OFA_^PJlEFJ_^PYCg2=O^P`W^]j;^Po=W>6S^"
    "PoQ]]n;^Q3BS[:W^Q77e6>O^Q<?eIi_^Q>_YNc3^QE_DJB_^QKYLFBg^QPT4JAS^QUp4]mW^"
    "QWCnBUK^Q]B<2B_^QkIEn]G^R:AM6A_^RIlhf6W^RTRIJJS^R`X]>Vo^Rm9k^F;^S@fJIeo^"
    "SE54>AK^SJd7:6_^SdJ96EO^T1kl^NW^T4oQ2V[^TNSEbF[^TTMMb:[^TZB;5]g^ThHN:NS^"
    "U8^_^J[^UAOD1Qo^USjjYnc^V;DkbEc^VFV^N5W^VI1@YaO^VRP96A?^V`UK6:[^VklHJ@g^"
    "Vm;mBB[^W9O=6EG^W:1ZJMK^W=cRN2[^W@c4aQ?^WDf]1n?^WF_b5jW^WPGpB:W^WSMi]^7^"
    "WWC;:>O^WWGG>B_^WWJfej?^WpK;N=[^X0_JNAS^X0g6:=o^X5gJb1W^X7ODFYO^X83B9e[^"
    "X=MR6B_^XARa:Nc^XJCEMRC^XKTp2QK^XZLc:AS^X`e2V=_^Xg]869_^Y4]_NBS^YMEAb9o^"
    "YPEf:RW^YV]72I?^Z1>iF6S^ZDUO:IO^ZIUUZaS^ZPNUN4g^Z`;HZB_^Zm_INB_^ZmjmJBg^"
    "[HSd>JW^[JFbRNc^[S7FiSG^[Zp1JEk^[gl`eR?^[iY421[^pO`GJEG^pfb4R9[^pi<V^1O^"
    "pn6m>FW^]70c6FO^]OT9F]C^]YZS:AO^]hoJ2>W^]i0HZAG^^5]Q]jO^^6^nfJc^^7NQ>BS^"
    "^<VQMMC^^<Y6f:c^^A=aY`o^^IG>MfW^^J91f8g^^OAFN1k^^Pj`RIG^^S:cnJc^^]Xh:6S^"
    "^^;ES6[^^ea8R=O^_5d86^_^_:X9>AO^_KmJV?;^_Qj>J5S^_Ti5RBO^__mc:Yc^_mPWf:3^"
    "`0Q<>V[^`DS;V9W^`Db]1mO^`RHnFN_^`bV[6>S^`d`e>a;^`l4HR=O^a2]C9ek^a7KZ>9g^"
    "a8SEF:k^a<2jJAG^a?S0BFg^aHa21nG^aLMEJ^g^aUO9]^3^aZDc99W]a[neJNS^a^lg:=_^"
    "aoTLFYC^b6@mj5g^b:TmgGG^bH86iYo^c81@b77^cFmJV5W^cKSd:9S^cNBCBNO^d9ei>EO^"
    "dAGF]o3^dHG1ZFg^dWYgB:O^dedCnMW^e166VEW^e8In=U;^e=d>>2S^e>F[VBc^e?@SAj?^"
    "eJREin3^eK4c=nC^eUoN:Z[^eWM8EaC^eYnbC6o^eZcOB9W^ebWmN2O^f54KVRg^fPpRBR_^"
    "fQLgFRg^fcknFe?^fd^QZ9W^gBb1:6K^gDl;BMO^gQ;36F_^gWW0B9g^ghlH5bO^h5ZOa^3^"
    "hA<O:dk^hA@Tn>W^hH4TYj7^hNg=ZMC^hZSZfRk^heGD2EW^hgNKV>O^hhCLmZ;^i1@^ZEc^"
    "i@^1f6_^iJpmn1[^iML9Mng^iX?bZA[^ig6UjC?^inMYFN_^jja^^A?^k7e=FNc^kPhV62C^"
    "k]oTB:W^kcGpAfo^kgF=JJc^l4=Jn0k^l4@0F6W^l::8FR_^l:neF=K^lFh?n5S^lLI5anS^"
    "lU?aZJW^lV@:j?;^l`DOAe[^m0ghF^o^m=][]b?^mDigZ9W^mW9k1f?^mbmG=nC^me7QFIW^"
    "n7bFF9g^n>S`Ye[^nGg<BQS^nI7^9Z7^nPSNbm7^nUVDIjK^nUeeeYk^nYpWQjO^n]V52J_^"
    "no2S^AG^o=7QF6[^oD]m6NS^oERZ6=W^oFUgR97^oHNc1V3^oI^3VR_^oJcVQbG^oTCe2^_^"
    "oVS`ZEW^oaECZ>_^ob=n>Ec^ocAhEjK^og?KZBW^0O3B?3;^0[QIji3^0n3g2M?^1GP6E^?^"
    "1h27g37^1mRMBFc^24P?Nm3^262nbAO^2:PTn6[^2ARG:Po^2OS>5jG^2i3MJIO^3FQBj^_^"
    "3MS56pk^3SSJVNg^3`1R>9S^3g3DIMk^3kPjVlg^49QaQec^4E19i>C^4Z3c2W3^53P2FXo^"
    "5@2:1ZK^5F2OMic^5M0AYN3^5l0fNB_^632XZ[C^6YPoY][^6f37AbK^7JR^o7?^7L1NB>?^"
    "8?1limg^90Sp?3;^9=1cjhk^9OPA2EC^9VR3=5k]9e2j:=S^9i0PE^?^:1Q1bN_^:IRQfZk^"
    ":O2gFB[^:VPYR];^:p0nn2S^:c2a:A7^;h1pjV_^;oSO6Lo^<3Q5B^g^<53dVJ[^<AQl>9W^"
    "<HS^IUk^<M1DVXo^<YSLAJK^<[2;Qec^<fQSiFK^=4RJf6O^=;P=2Nk^=U0LJY7^=b2T1^O^"
    "=nP[]V7^>TS2ZWC^>lPR^lk^?;1IYaW^?GSQAnG^?XS?9eg^?lS8no;^@91@ZK7^@mPNR6S^"
    "A:2V=f7^AR06Bg;^A_2=j]3^B10[2AK^B82M=M_^BJPjEfC^Bk2kfN_^C0SAF>W^C813RIK^"
    "C=QHmnG^CDS;:=C^Cb10Y6GpDQ3i6M3^DU1OFc3^DjP8M]g^DnQ^ZY7^E;3fAVO^EH1mmFG^"
    "E]0W6F_^En0Dk7C^F6PfJQC^FCRn1bO^FP15]Z7^G63LZS;^GNPl^lk^GpQcYaW^GgQ<0moX"
    "Gi3kAnO^H622n5_^HN3S2_7^HZQZZ>o^J3PPB_7^J@RWjQ7^JRQ52=O^JZ2g=Uc^J^0MJDo^"
    "KEQSZA_^KLSEfFO^KYQMRA_^Kf3U>5O^LCQJ]Eo^M2PC:E;^M6QiFRc^ML0RMag^MP28ZIC^"
    "M]0@A^G^MiRGmN?^N?116BW^NOP^jc3^NX1@JIK^Ne3H1jO^O1QO]b7^OVQ7JZg^P01F^Xo^"
    "PIQV1JC^PoSm2S3^Q<24Z:g^QM1bR^g^QYSj:a?^R309MEg^RAQ0J=g^RN386FW^RU0jB_7^"
    "Rb31jI?^S;SAA]_^S?PgN=?^Sn3_jBC^T;1gR=k^TGSo>1[^TL1UJQ;^TeQd]Ug^UF3f>o;^"
    "UT0]:E?^UX2CFJc^UmPlMig^V1RRZMG^V>PZAbC^VG1;b1W^VK2amV7^W118nVo^WI2Xo0g^"
    "Wd1WUf;^X81QJJ[^XI1?Bc3^XQQ`^Q;^XUSFj;3^Xk201VC^YJ2Tf6O^YQ0G2Jo^YVPpMf;^"
    "Y]RNZ6[^YnR<R^o^Z;PD>U?^ZU0SQMk^Zj3<ZRO^[5RU377^[71DBVk^[CSKnAK^[O2dG0o^"
    "[]3[Aac^[a1AN5K^[h33Y23^piPI=mc^pmQoJMC^]4SaTm[X]AQiA:K^]G2>]]o^]OR`:??^"
    "]gP@>Zk^^9R]FBW^^S2lZIK^^ZP^eUk^^`14EjG^^lS;m^7^_k32n]7^`RP9>1k^`YQkJBS^"
    "`jQYBW3^a32:bI?^a73`n6k^aLRJ5^G^b2Pa2Fg^b?Rh^2O^bP2VRW3^b]0^>EG^beQ?Y^g^"
    "c6PmQYg^cW2o33;^cXQ^BNc^ce3en=S^d0S>Flk^d=1F1:C^d>P5Aec^dBQ[N1S^dJ3MY9k^"
    "dX0DV6S^e01d[;G^eO2IJIG^eV0;UE[^ec2CARS^ehRX]ag^fI0Z>F[^f[S7F>S^fbPiRIC^"
    "g4SFZAO^g<18eak^gAQNEjG^gN3Umb;^hLSM2U7^hf3pEJG^iL23BJ_^iTRTbEG^iXP:n2_^"
    "i`1m:pc^in2d5fG^jT1;2F_^ja3B^2K^je0hjbk^jl2[70k^k1S0RVo^k>Q8>EK^kERjI9k^"
    "kX1GQ]k^l8SI2g3^lR3XF`k^l^Q`1NK^ld25Mm[^lkSgYB3^mQR>ZgC^n0RcJES^nDR]A^K^"
    "ncSB21c^njQ4>FK^oD1CV=W^o]QRieg^00002:7^0;jUV23^0YENmfC^0m6a>Mg^1@Y1V=o^"
    "1eN6NAg^2=F=EV7^2C9:V>G^2OO7Af7^2[Ipej3^35mU1R3[36786>?^39M<Ej7^3>gnU^;^"
    "3B[p]Qo[3IYHN>3^3JbT=^7^3OIdIU_^3p7l1Uo^3hf3]f;^3i0o^Mo^4Fp3f6?^4c><V>7^"
    "4f7`jJ3^59Z1BIo^5M<AZR3^5XlCUik^5`@h25k^5jA[Mb;^6<JUIj3^6=PeI][^6HE:mio^"
    "6J>m663^6ZN4ij3^6ddH1b;^6fHZN63^6kcL]ZC^77^2Eeg^7BZH:Ao^7DL9nB7^7ag3IjG^"
    "7b1oJMo^7l[HnJ7^88KJimk^8^i^ab;^92[12Qk^99m<9nK^9Ega]]k^9F=AJN3^9KZ_2:?^"
    "9ckA>27^:1a1aF3R:>O9MJ7X:@JNB>;^:GIS1Z7^:K=A9N;[:SD8Ub;^:WkHaN3X:dYPMYk^"
    ";1GX5f;^;O=XB>3^;[2o:Ug^;nU?R5o^<hbLJ5k^<kp0^V;^=2c?e]o^=9DB9Mk]=?>A6R3^"
    "=Dl9ab7^=F2IeUk^=Pf_If3^=R`QNN3^=boYAj;^=mElIj;^=nj>in7^>4E19Z?^>@?V]]o^"
    ">H:I>:7^>Lm^In7^?H>WnEo^?T3nfIo^?gKC=fG^?gV?>9g^@BN`Uj?^@NIF9f3^@acL6Ag^"
    "@d]0JR7^@lLeYj7^A8?@fJ3^AG0]eJ;YAKaQ>Io^AOk7Ib3^AS^eQJ3XA[e]1j?^A`Lm=Qg^"
    "Am;4eYg^B9i<Qf;^BT]YBFG^C@;jn:3^CC1IN67^CKklj5c^CQQBebG^CoJ>]Z3^D;DdAm[^"
    "DAefUZ;^DMM^=j?^DNSn=V;^DYHCab3^E1@@RB7^E5gPf27^E7KcAb;^E<fUQZC^EDbPjMo^"
    "EHa;9b;^GVjjQn7^Gm:O25g^H:I<Emo^HBd:UIoUHFCaifC^HORBAR?pHXL[en3^Hp@ImJ;p"
    "HdGAIf;^HhnQUQo^I5pYA]c^I=cPVEo^IBJ`ij3^IIXgNI[^IQE`n:3^I];7f9g^JKRmj27^"
    "JZ2g=fG^Jmd9N:3^KCfHY]c^KJGJmVC^KUoBUnC^KW5RYZ7^Kaih=f;^L3?@1^3^L8Z2AVG^"
    "L>I5>23^L?mG]b;^LEH9m^;^LQB_Qf?^M6dPFB3^MJF`^=k^MV<7VI_^Mi^GnJ3^N8NL1j;^"
    "NAHoMV7^N_LNmn3^Nfa3F23^Nfe9:Mk^O0afa^7^O:GIR9o^OBj`^67^OKE_1JKSONeFEj3^"
    "OX3fYNCZO`n@>B7^OdanEIoYOlhef63^P1P61Mk^P>>=Yb7^PJlEFB3^PoeP25o^QCG`JEk^"
    "QHe>26;^Qb_GZEk^QnDMUR;^R@MGQn?^RLGm5]o^RRhoI]_^R_W71^7^R_f8jF7^RjKLUj3^"
    "S3HIBEg^S;`dM]o^SA;V]VC^SFjYZB3^SMi^EfC^SYdCmf?^TCmE223^UA00In;^UIjSeio^"
    "UOk0R:3^U[?k]nG^U[`GJIk^UoBWbEo^V9CK=b;^VKLE9j3^VWFj]n3^V`UK5IkXViOdYn7^"
    "VlIHnMo^VmCRaQg[W5JJ>67^W:1ZIUo^W?kYFIo^WF_b5^;^WSMi^:3^Wd`^>A[^X5EQ2B7^"
    "Xk601f;^Y6f1m]o^YHl0>Qo^YTaG6Ik^YTiQMf7^Y[JSaY[^Yh8[Mf?^YhCWNAg^Z2m11j7^"
    "ZDBHeao^ZEn[V:;^ZI];5RG^ZVKBaf?^ZbEhEb?^[8lY2Mo^[LNiJZ3^pFp6F>;^pIQTf67^"
    "pRL8Aig^]5jJ1^3^]AdoUb3^]Aloj9o^]C^a^5o^]SmiQf7^]pHgeJ7X]_hO9mo^]aDW:Ik^"
    "]i6oMN;Y^1=fmek^^5e79U_^^=knYj7^^BS>eMk^^OAFM^;^^^GBV5_^_1k?Qio^_1mXbR7^"
    "_EOi:N3^`3WTMf7^`?GVIQg^`Fp:afC^`NL1>>?^`]K5j27^`cl8=Yc^a0Z?ej3^a9jBn>;^"
    "aLcmAj?^aNP@2:7^aR>_QVC^aZEVjEk^a^9E5V7^a^lg9n;^ajgLab;^amggB1o^bjnXNV?^"
    "c>PhfN3^cR39>>3^clC4QYk^d>KnMb7^dJFT1ao^dL@F:63^dpOMmf;^ddjL=IoVdhJ3Qf;^"
    "dmdea^G^e1XSiR7[e9_KIb3^e>F[UUk^eFMS1b7^eGQ?^Eo^eK4c=Qo^eSFVVIo^eWbjib?^"
    "efhfn5g^ekT=62?^g7QhVJ7^g;nU=nC^g<98en7^gC<CIbS^gCG?NMO^gGi:aZ;^gK48nAo^"
    "gO=_=j3^gViOf9_^gelZAn;^glMpUYc^h7B29b7^h9;dAf3^hEAEfAo^hIJl5mo^hN2<AJO^"
    "hUEQYj;^hZ`CiVC^hfZiQag^hgNKV:3^hgRQJB7^i3I19j7^jEKaV5g^k0RhBR7^k4dXi][^"
    "kD58ZEo^kFmRej7^kOjORI_^kRh8Ib7^kcL_j9k^kmL0YIoYl0kWmj;^l6FJ=^;^l::8EN3Y"
    "lB@oab3^lFh?mMo^lSVGYQk^l`DOAb;^l`OKAmg^l`SQ:J3^ldjheio^m45aR9o^nDZ]B63^"
    "nPJ_=j3^na`71b?^nhA9EYW^niSgn1o^o3i0mmo^o4oA1Y[^o=68FF3^o?cVUb3^oA]HYj3^"
    "oPXH^:3^oQlPN23^opBcU^7^opM_VEg^o]g65j3^ocAhEZG^oo<Miec^00001fK^05^ZJUK^"
    "08:inZ_^0A3AMf_^0NVO>IS^0RBhNUO^13c?nJS^17TDEQgp1?CSIZ3^1@Y1V1k^1pJ9eUk["
    "1]:@f];^1ac9EB[^1bCIbY3^1bPXj6;^1c;J>VW^26VP:]C^2=DXZa7^2HUJ^UO^2SjBNV_^"
    "2V<MNQO^2^;VMMk]2aZ1ZY;^2k9BZV[^3AG;9Mo]3B[p^2C^3J]bZ^g^3LAEjRW^3_m35Mg^"
    "406=f]C^40Dka]S^47M5RUK^4Ba<fIK^4K:TVRW^4UlmUho^4V6DMUg^4po5bJS^4]bK^]?^"
    "4`7YjQS^4a^OYJ?p4fhaAn;^4hRgYV7^56Z@RQO^5:R^jg7^5@B1^QK^5@^]]V;^5M<AYmo^"
    "5O3jIB3^5UZ;R9_^5e_IRR[^5fUo:E_^5gGD]aW^5o3i1f?^61OFAI_]677aVIO^6@?9QR7^"
    "6F54>QG^6JG;6EK^6X^OaN3Y6c>ojIG^76T7R=G^7@pNJVW^7HHBFRS^7`_dbQO^7bQi>NS^"
    "7bUWbIS^816T:6C^8Aai^FS^8B2GbG3^8WUTZQO^8Y]7IEc^8jdn:AO^9CpbnAO^9Ef=6UK^"
    "9EfU]jW^9UpCRMK^9Yk5FNS^9]LHfMC^9^FXj^_^9j;V2a;^9kCTjbg^:05dMN7[:0UDBRS^"
    ":3Zg6V[^:7Uf^IS^:LNIjAO^:TbjFJ_^:__VnRW^:hBje]g^:k5Q=bS^;1jp1^[^;83G^MO^"
    ";8Wb>YC^;9RR6NS^;>oWJFW^;F@Y^^c^;JbPe:[^;KBa>MG^;Y9>FJS^;d:V2=S^;hY>BUO^"
    "<HcV6]?^<ko7afK^<n@mnZ[^=5lafBS^=7QGUmg^=?oAJ9g^=GM95Uo^=pMdZZg^=kV`Ie[^"
    "=k`TFQK^=l:>nRS^=n`[]mk^>76kVR[^>7>UR>S^>=;ZEa[^>?8=aI[W>?pOFEk^>H:I=j7^"
    ">IianMO^>Pif^V[^>VFl6JW^>p`emV3Z>gc=J>W^>i^5=Z?^>k3MZNS^?HWM9IcZ?^RBU]W^"
    "?`792MS^?`[=6VW^?b>[aQo^?i>Q1Z;^?n=IZ]C^?nZYeZ_^@3FRVEO^@:@;ej?^@=iDN^c^"
    "@J=4F6S^@L>GJMK^@[8gn37^@^dM]Ukp@`C_9YW^@g71ZB[^A;V]f4c^A<<KN^_^ANN@>NW^"
    "ATonB]?^A]NE>=W^Ab5;aUo]AhA;FRW^Am^@^JS^B@Tl6QO^BA9FZa;^BB46Nbg^BGQ;fJ[^"
    "BSdEZMO^BTUoBFW^BaD6nF_^BaZbbBS^Be?KZ5?^Blp:NES^Bm0pnRW^C1:b^QO^C9V0MRS^"
    "C@1B6=S^CF7BfFS^CQE:RYC^CU@Y6VW^CeHbfRW^Cgnj:>_^Cj<oFUS^D6;bEV7ZD6bRF^c^"
    "D>NFBJW^DH:jJES^DIS3F5O^DXWm>FO^Da2_>MO^E3ahEBG^E4B8^QO^E4[cJVW^E?XP2RW^"
    "EH9mnF3^EM9mREO^EQ_W>VW^EVa^^EO^EXPDfRS^EYKK:Z_^E^hPNNW^EaS[NBS^F3U22NS^"
    "F8[KVc7^F927JJW^FPE5^2G^FRe2R2S^FXboRB3^FZAaJRW^Fa@iEn?^FhX]NQO^Fj0fJ9S^"
    "G:ZVf9k^GAPRBIS^GFJhjbc^GT_kbIS^GViEj]?^GbjNJbc^GoXV2J[^H0EU>]?^H4R:>:W^"
    "H:hBIF7^H;cFm`o^HcCTN>[^I0b_b^_^I4?H:3?^I:[n9bS^IE;;f2[^II6PRIO^IJNYNAO^"
    "IJUZjg3^IJlF^RS^IMbDiak^IP2`>R_^IR=hM^C^IpEj2IS^I];7en3^Iie[FF[^Ij<G:>S^"
    "Ik=KbUO^Ima05Q[^J5=^f=[^J9pG6UG^J>eP2]7^J?2_=nC^JS8VJUO^JYf^jUG^J[F5MF;^"
    "J]b=RZ[^JeF?VF?^JmjG>RW^K>]FaR7XKG=fn@[^K_=bn2[^KlmV]YG^L<c]:QO^L==GbZ_^"
    "LLXD6QK^LLg21a[^LN>c:1O^L^hn]Qk^L_CC6IK^LbC[FRS^Lbl3]NC^LgJ4jR[^Li0YV=_^"
    "LofdV>K^M;chQN3^MAS[fF[^MQ^KjB[^MW4e:fk^MYeUAZ?^MYnIN6g^M`ZKAYo^MkV0]JG^"
    "N1:AfYG^N2<Ab5g^N2RJbAK^N4bfAFC^NJ26ZMW^NKJ?V5W^NKUoAjG^NNlMBZ[^NQ=Q:Ac^"
    "NQB_6VW^NV4[IV3ZNpa?aFG^NbKgiMWUNnpV>9S^O1iO^9c^O69E2ES^O8::NFS^O:GIQjC^"
    "O?a6:MO^OCIfaV;^Op?0j5g^PS0=fEO^PS7?Bfo^PSMk6NO^PXTDZRW^PXk0NNS^PdWVNVW^"
    "Q2G?bBW^Q2]kUnO^Q3_0>UK^Q6BTMM[^Q<J4Z2S^Q=l5JYG^QO:IB5W^Q^Ap2BO^QbHCFQK^"
    "QcgYiZ?]R2>Ib=O^RAOS2J_^RGe[:Z[^RXg0nRW^S3N0nAS^S:`SnMS^S;=?m^?^SEEARQO^"
    "SU9hNUO^S^IhNQO^Sbb`2VW^SgdgRQK^SjNSn^g^Sje?^NO^SkMX9Yk^SokYBRW^T1@:bAW^"
    "TDELmZ;^TH]2bFW^TI^TJJ[^TJ5@>FS^T]S^>QO^TbOmiZW^U;3o>A[^U<:36QG^U=DJYNC^"
    "U@aRZ5O^UO4YjMS^U[>G2QS^U`5QAUS]UfO96MS^V3EgBR_^V7>:ZAO^V@[^fZ_^VKBamj;^"
    "VKkK=]_^VS`[b:O^Vp>UZ=g^VdpOMjC^Vdc@1R3ZW?i7Z2S^WSMi]^;^WU[FBfg^W[QbBES^"
    "W[Xc^bo^W[paUZC^W[oORVW^Wa5i2FW^WaLTfRW^WlgW>EO^X:=nF6S^X;?On6S^X;p:6QS^"
    "X<@TVQK^XEXX=ZO^XE`WANC^XFMYbYG^XFll:MS^XJ_OjUK^XSQG^=?^XVbB6:G^XW[m^AS^"
    "X]N>=aW^Xf_:Un_^Xh`MZMO^XlI>AV?^YEA35EcYYW]=f>K^Y_?ZeUk^YePEYUKpYfLHRGC^"
    "Z699Fbg^Z7H<:NW^ZNW<JZ_^Zp9m:QS^Z][LjYG^Z^V<bZ[^Za17IAgZZfkLfQS^ZgJ_>MS^"
    "[3Fd:NS^[89`b=S^[8M=^NW^[AaQn5G^[Lg1EZ3^[RVdZBS^[k1RARK^p9JgElg^pCUSVQK^"
    "pJFZmmo^pRdTf:K^pc_kN]?^pd<WMZ?^]GI?nQS^]I=CB^c^]TLoUQo^]Y^F^QW^^U=Qjg?^"
    "^d:H6^g^^dQ3jRW^^in9BNW^_=boYfG^_D=^RUO^_No>>QO^_ONPRYK^_W<]:0[^_i8NV>[^"
    "_jXbnBW^`3KL:QK^`4jb]a[^`?LTZZ[^`Ga<:bk^`Lg[NQO^`WJHYJC^`WjY5IgZaW8`bbg^"
    "aa]B6>K^ad[QVUO^ag0_^AS^ag7a:fg^an_naVK^aoM1BUK^aolCZIS^bAEMjRW^bJC6EUW^"
    "bPNpF:W^bUHUaYg^b[8I2BS^bn@JUIg^c7h;]Vc^c@pUEjS^cB07VFW^cL782aG^cNGSMN?^"
    "cQ@@n9O^cc_m>4_^clAOfe3^cnPDBaC^dE9DZMS^dNMbZV[^dPJ6^MO^dQ^gZ^c^dp3M]Yo^"
    "dcM;:9_^e?N:1JO^eFWl>=[^eLHjf>W^eO4Z61o^eXEne=c^eXf?=eS^e]djEN3^ecihUEW^"
    "em2XFVW^f4>PVA?^f6POb:g^f=pc]JK^fKA7:F_^fLBXbBS^fL_BjYK^fM;niZ?^f_VFmUg^"
    "fd7fBUO^feW7^MS^g=LG5aW^gNKUn=k^gP0XfRW^gTl2n9S^gVD;i^7^g`L=MI_pgaGcQQg^"
    "h8a7:1k^h9D2B=K^h_4WVA_^h_ZE>fk^hm=5nUK^hoRD:IO^hoYEV^c^i0E4bIS^i8Mh2a;^"
    "i;A==IO^i@l>jEO^iRdZaY_^iS9^EQ[[iU48EMk^iXl:n2W^i]j:9]_^ieH`F=K^ing3MAc^"
    "j0`SZVg^j:cbBB[^jLC76>[^jTXpJa?^jiU<RFS^k4c4Ba7^k@3fBQO^kKLcjBO^kMZi6UK^"
    "kW_F=N;pkXk[6MS^kZ@L6fk^l>Gm=ac^lB<>>^g^lRXQeEo[lW?b1R3^lkWgZ1[^m45aR5c^"
    "m54p^2G^m5=Pj^c^m:?XJAK^m?249VO^mE1U::C^mMOO2=c^mSKo^NW^mU9^b1W^mU@gFUO^"
    "m`1C=Ag^mai0ZBS^mn8p:QS^n21:NJW^n9IN:MW^n]=e:R[^nnV=:IO^o68LZ2K^oAEFA:7Y"
    "oV8]6MC^oX03n6S^oYSRjV[^oZ]KR=S^oiofQQ_^000022;^04:C62K^05pWQMk^0EG7Z9[^"
    "0FJ;AEWp0pRVN6S^0pm2BQG^0^=lER;^0cjhV:O^13Ck1bO^16IAVQO^16iXZ:?^19^TNIO^"
    "1@3V9:C^1CdC:VW^1F_A5RW^1TFZUF;p1lWjJZ[^1nn0fMS^2;p8QY_^2M3oJNO^2O2PNRS^"
    "36C6jNW^3G4K>AS^3QVQbRS^3TlkJBS^3ZfCZ=K^3_RENMS^3hilJJW^3n^5:BS^4BF;^JS^"
    "4G2cF=c^4H3Z>QS^4PMen9S^4SDImB7Z4fjFNIS^4iLe66S^50TnnQS^58UDB6C^5>16RA[^"
    "5OK[>IO^5Q`K=6[^5VbFmj3^5X_fNV_^5Y6C^QS^62<5bRW^6:A_mJC^6AWXRUO^6bc4]>G]"
    "6nf@RVW^7F>enIO^7KDIMRO^7RB9EM_^7RZB2MO^7^`IjA3^7eNV^UG^7hJTN6S^83e^ABC^"
    "8<mLV1W^8UP]JNW^8U^]5j3^8pG31F[^8`>XUQg^8aO_N2O^8jaMVMO^8nOmUZK^9:@on>c^"
    "9?pb:1o^9D=pi]S^9DhGaZW^9UUSbVW^9XN2Z:;^9mIpQJW^:30DNVW^:?RU6MS^:Q?h]Eo["
    ":`diN2S^:hKobUK^;>9XNBW^;_<H1Eg^;_[5F9S^<H<J61S^<WipfNS^<Wm?ZIS^<Yh=jRW^"
    "<`mZQJ?Y<aAJfR[^=0;Y>2G^=@NTJEO^=AHMemS^=INoEMo]=Z9^B2O^=e6K>RS^>20D5IkY"
    ">@RZbVW^>ZQXeR7p>^:7IEoZ>n0;6US^?53kjQO^?AYSUAk^?C2mUUk^?GLJJQO^?d>cjRW^"
    "?kTBEMk^@3C22UG^@CLmFJW^@L_AF5S^@T5W5Qo^A1gDj:_^A<VkiZS^A[eIn>_^A]7faF3^"
    "AaA<:5_^Am>mQ^G^B3@Aj6S^B9m5>NS^B:2LZ6?^BDj;BNW^BF[<fNc^BRc]9nK^BXKd=mW^"
    "Bk4F1J3^CP]nN=S^CUJ0BQS^C`KA>RW^CcaZfNS^CiboBRW^CkTX:RW^D=kE2IS^DC?>VR[^"
    "DD1R1m[^Dp5V9=kXD`=RB9O^DfLYbMS^E3S0R:W^E6beNRS^EECF2MO^EGX619c^ENmnRMS^"
    "EQ`3>2K^Eblgf1c^Ede161S^Ej25MF7]EmdZbEO^F09JaJg^F7OCFIS^F;^8F6?^FTOHb6S^"
    "FXZ_QBG[F`0X6UO^Fb_JBJO^Ff6e6QO^G;dVJQK^G?eYFMS^GA<4A:S^GHQlfIO^GU@e^EO^"
    "Gi]I5>S^Gol8ZRW^HR>]eF_^H`Y8IU[^HhodeIg^Hof2fQS^I5`QmV;^I:`2UVW^I?8?n6S^"
    "IO<aBN[^ISK^j>O^IVVURRW^IcAGEBo^IdXSN5K^JBeV>=o^JJlA:V[^JNBZbJS^JV;4NFO^"
    "J[VfZ5c^K4H79j;^KUR`:5W^KgmT=F3[LVeEEEoWLcTiV=7^M5j3MF7pM6F?>QO^M<F:6UC^"
    "M?3CjQO^M?FZ9J7[MXOS>QO^MZS<b5_^MZn62VW^M^gSnAO^MfD?:O;^MggniN3[N3DMAb;^"
    "N=9_MF3XN?5OZ>k^NDF:fQK^NDQAf9[^NHG=bUK^NN:4V1W^NPICYR3[NQ9pRRW^NQFgMF7p"
    "NWf`5n?^N]BRF2?^NfkCUJ;YNjkV^QO^O63bb:;^O8jXIQo^OAXRjVW^OaKm9R;^Oi:peYW^"
    "P4gbeEgpP6;IMEkXP>B6EZK^PImAiR3^PLf`>NS^PW^EZN_^PmU7^NS^Q2NV]N7pR4b>>NS^"
    "R:f86V[^RF<mR9c^RGT?^Vc^RNCO1m[^RTBGJNW^S3eRAJ3^SF03JRW^SKA[6MS^SoR9=MWR"
    "T3bofMS^TTBonUG^TUanVRW^TpDDV9S^TlZPBRW^U;;0fMO^U=O`eJC^UDeYFQS^ULg_>IS^"
    "UcpEVIO^Uf15U>_^UfCnRMO^UmFn6IS^V2cAYAgYVGhY9l_^VHkpb6S^VNRJEQO^VQOE1n?^"
    "VUhBjIS^W73_567XW9K:6:O^W>IWZQS^W>flF63^W@_`iJ7[WSMi]j3^WWX<b2?^W^;YiJK^"
    "W_U3iF3^W`?j6JS^X9M5^NO^XH6HY>?^XOe8BMK^X[oInRW^XcQOeJ7WY0W]IRS^Y120bRW^"
    "Y1a11B7XY=CbVV_^YP5d:Zg^YY929>7^Y_V?bUG^Z8GP>Fc^Z=cBN1c^Z?]PAEg]ZWpMZRW^"
    "Zc=C:R_^ZoEcInK^[54KNRS^[8Je:NS^[?`9AM[^[@RWn5o^[CHE6UK^[YChN:?^[pdTJYG^"
    "[bjZnRW^p3k_^9S^pUICZMS^ppM4N1S^p`SXEa[^pl=j2QO^]5>DmN?p]>[?]F7p]T_>bIO^"
    "]]_Y]U[^^>iMUjS^^F@nMR;p^OE?:6S^^`Wp2NW^^`cARMO^^cn5ZFS^^haNNJW^^nbC=Mo["
    "_11O66[^_B>CZ=_^_IDVBMS^_WCWmN3^_ZoT9nO^_pG_ZIW^_`KFF9c^`6LDZ6C^`9<Vf1g^"
    "`=Xo5AoW`?dl]N3^`B^K2VW^`QmgAV7^`SaJ>6S^`XWHRV_^`gN>UMg^`hFAQRG^aKUNE=kX"
    "aPgVAJ3XbA:Yb=3^bKiiNUC^b_GpN1[^beF8bUG^bfe7JNS^c2]:^:[^c88lmmk^c<V^ME[^"
    "cA9EjES^cCioF2k^cPj=IbC^cp[?b:g^c]jh2MO^cb722=_^cdnXf9O^ciZZZMS^cjXo]Y[]"
    "d7G7FIS^d:hBN6?^dJS=]M[^dR;oJ=S^dSYRn6O^e12[ZIS^e3GKYO7^e:]D:QS^eC@RVJO^"
    "eYT0JIO^e[h`I>[^ec>XjQS^em`HJVW^f1C2jFW^f;TMeJ7^fDJ59^c^fK_m^IS^fY2U]Eo^"
    "f`hA6MS^fa3H65_^fjp:ei[^flkIi>GYfmhm]:K^g4ABNMS^g4HfIb_^g8nU^RS^gGp]ZV[^"
    "gIPm9F3[gRUi6:?^gUL^]R?^gpbW>QO^ga8lnV_^gcb]Z5c^h=n3M>S^hR]O]2G^hUE>V>O^"
    "hfOH=Fc^hkMINNW^i4@KnRW^iO0pmR;^iTKMjUK^img]>QK^jHNpQJ?]jQDDNRW^j^W7Z6S^"
    "jb_3b1;^jd6EnVW^jiO:Fa3^k3:T5Q_^k<:=b5g^kVK;aES]kXbEbVW^kicJR5S^kmaRNNW^"
    "l>?Yb6;^lC[L2AW^lRD_B5S^lW0jB6O^l`HGn>S^lb5TfQS^ld0S6NS^lk5oaNCpm5=ln2?^"
    "mGLKiUC^mJViVIO^mSWDQN7pmW1LV2S^m]Tg26S^n<8YAZO^nP>B2R[^nUHk9QW^nVZlFUO^"
    "ndJ_N93^ndYn1Mo[niZQFV_^o=;ojQK^o?<A6QS^oM;BaV3poN6?nNS^018BARC^04C_UfK^"
    "06b;bV_^082cbES^0=iOenO^0?;D1j?^0?H?6F[^0BZnnMG^0FciIj3^0LYN:JO^0QAOj=g^"
    "0ZjVBJ_^0bACVAg^0cC^QYc^0d3fafC^0hRmN:W^0jb>a]W^0jbPfN[^0jkBJE_^0kADe^C^"
    "0lY429o^0la=Qmo^0oRRVAW^0oYSn]7^188UnEK^1>B6F:K^1AjK>5W^1D3C=]c^1Dh[FF_^"
    "1E`Jnno^1GXd>J[^1I3SRVc^1M[UBE[^1VhMmYo^1Z2_5b3^1`;Mj5[^1bPXif7^1c1^1f7^"
    "1d8Pf6K^1e9<FBc^1eafjjk^1jjRafC^1k`RnEk^1oZP2o3^22JKJ>c^25jV^=O^27[<>2o^"
    "283XAfG^299kREW^2;jFIbG^2>HPVE[^2?hG9RK^2@QR5]k^2@RanMS^2CB?2FK^2DH@A^?^"
    "2Gk:mE_R2H2@f53^2Ihd6JW^2JR2^E[^2K[oJ^o^2L0=jV[^2Lb:5bK^2PSN6BO^2V[a20o^"
    "2[04Yn?^2pH<AUk^2]iS=e7^2hc5JEO^2jSZfJc^2nYaIQc^35C5b>W^39H8^>W^3;KH^EK^"
    "3<Jl6IW^3>cXiRK^3CJi5jS^3CX=jZ_^3C`GN:C^3DhenMG^3EPW>:C^3FkFNBW^3H:>BZ_^"
    "3H`KQi_^3KSHBAO^3Khbj>W^3LK09i[^3P90]^K^3Pb1f5[^3Q;cR1[^3pcJJA_^3^jhb=[^"
    "3_RO]jO^3cYYj:O^3e8I:ZG^3fI1:=g^3fjlJ1S^3kY0JF[^3mRBnZg^3nbk2IO^3oCJ]iO^"
    "41a;:N[^42BDbIO^43jZj=_^47aDUiK^48C861k^49[?^EO^4:k[R:O^4;0M6=o^4<HTbQ?^"
    "4@K;]a_^4CZPNAW^4FBSR9c^4JP_j:K^4SBV>BS^4T@WIU[^4Vi:j:S^4YAOb=o^4pbQAAo^"
    "4a[IZMg^4cI1b]G^4fBYf9o^4nXJ:]C^50[6j2S^52[i6bg^5?cZ^NW^5AbGN1[^5B`Xj=?^"
    "5EKDImg^5H`HUJ;^5J3nB]C^5LiLfQG^5NQ[B9W^5O;UYjk^5QKkJFS^5S3Cb2S^5Xb@2NW^"
    "5pYn:V_^5]IP>N_^5^0]JVW^5bA[R4_^5b`_>IO^5cP=VYO^5lZ]nAO^5o3i1f3P61R39mO^"
    "658Wf9O^65Y7RIK^67Qbe^7^68Cc2Ic^699ZanW^6B`E:FW^6EP@N>c^6EYUEnW^6FHYn:7^"
    "6GKUFBW^6Jk`ZAW^6VH4:Fc^6XCHn:W^6XIJJIS^6ZJbbN[^6_:dV]C^6_S<VMK^6cYC::?^"
    "6eXX2JC^6h1b>2O^6i8cFEK^70Sp2:[^75`;YnC^76PKZJ[^7:;0FFW^7=CgBUC^7=`?BIO^"
    "7Eaa6]3^7L8e=Ug^7Mh]6:W^7P:ei6C]7R3gBFG^7TZ_1Uk^7WZ^VFg^7XH32BO^7Y2@Aeg^"
    "7ZQa6BO^7[hPJB[^7]8XeUk^7]c3Z5g^7_A6AjO^7_kCRBW^7`XR:AO^7ec;b=W^7n8l6=[^"
    "812T9f;^83h2^Ac^83h:ImS^89PMn1c^8:9S6JO^8;J;69_^8=RdaN;[8>aTfEK^8?0@=Yk^"
    "8BR[EfC^8B`H2EO^8DJ0:5S^8EKMAb?^8N0ZQN3^8Nc1B33^8P1W2M_^8X[ZJIW^8Y[O2UC^"
    "8]j?MmS^8`[^1j?^8`hY6BW^8gPieUS^8n9h:N[^8nBY^AS^91c[=Ak^9A0?21o^9AYMZBW^"
    "9CYT6aC^9Ca]VEg^9DCe1^?^9EX@ejG^9HZZN6K^9J;GN6O^9LJjfN[^9La^ebC^9Q2lVAc^"
    "9YXonEK^9ZHNEig^9p[QB>O^9]9cJMC^9_jPFBC^9cRe>9O^:0SEEbS^:9An69S^:;S95f;^"
    ":=C122W^:A[gj5_^:D12mb;^:E`jf6S^:FYVJB[^:R@eJ>c^:U0fUf?^:WK0bAK^:Y2gEN[^"
    ":YCV>;7^:ZQJJJS^:ZZER=S^:]J`MbK^:dbORZg^:djY6>K^:ehZA^C^:iRZf4o^:l:L^EW^"
    ";1PW>JW^;2;h6BS^;5JpN5[^;8@;24c^;8ZM66O^;?BGaV3P;?Im=lg^;FSg6AK^;GZkn:;^"
    ";G`AUUc^;L84jJc^;P:QMI[Y;VkOb6[^;ZhR^:W^;[X19McY;]3b^AG^;e@aN>O^;hK`NBW^"
    ";mI<jBW^;mQ`9Z3^;oRk22C^<2BKf1k^<2`=R1_^<58@MI_p<>KdNA_^<@KBbAW^<A2i]nS^"
    "<C:629g^<EB3j6G^<EcK2UG^<HSFIiW^<NQWiak^<O:]2RO^<P[_b>3^<Sb^bMO^<WSe=eg^"
    "<Y@lnbc^<a:OUV3^<e:jNAO^<f`I6UC^<l19j6G^<mK7UJ7[=4JjB>_^=5`gib3^=8QTj>K^"
    "=:0Q^>c^=C;22Z_^=CCcZEg^=R;PinK^=VZWVJ_^=XbgR=k^=YHnin3P=ZQA>6[^=][dJ2_^"
    "=_8QJ:[^=aH4bVO^=abhaIo^=d;kUV?^=f86RIW^=gCHiZC^=hB5eZW^=hc;aRO^=kjY5jK^"
    ">0i9:FO^>1`[>6O^>30ENB[^>5QCMV?^>>Jbj5_^>Cb5R0[^>DA9>IS^>H:I=b3P>HhIJAg^"
    ">PXC1f3^>R@:ibS^>Va1f5S^>W3P6:S^>Yh=6Ek^>[Z`B2[^>_X]FUC^>bR;jYC^>caWaZC^"
    ">lP:Z9S^>lj0imk^>n@`::g^>oRBAm[^?4j4R9W^?7hDZZc^?80N:BW^?98lZIO^?9kbnB[^"
    "?:1dJAG^?<IW6:S^?@ALj1S^?A;VVES^?CK^1Z3^?EA]>2O^?G922NG^?Ih7ANG[?JY=FEK^"
    "?KAfUaO^?KiWe]o^?QYXV2;^?RaV]Z7^?S;7>IS^?TK79]G^?W@U^2?^?X8eZBW^?a9>bBc^"
    "?eCEEY_^?hj@2]?^?iAF5>;^?ma?=j?^?oI76>W^@3RKBQC^@6;91Yk^@6AhFJ[^@:RZAmg^"
    "@=PjJJW^@B8l:=S^@CS7Jbg^@D9DZ1[^@GCUb9g^@M2ZV=O^@RZn9j;^@UPL^AG^@X2`EMo^"
    "@Y1IZ1k^@[Ym6FG^@]PPFEC^@`InfUC^@b:TFB_^A1Q?NJ[^A1Z12=c^A6JRIZK]A70_ZAK^"
    "A7hOBUK^A:@4JES^A;`4eeW^AB@81j;^ABQ3:JO^AMR^f6[^ASH5=Ic^ATJCjB3^AVYC>jk^"
    "AX;in9O^AYHZNaO^A[9::9W^A]JE=^C^A`QlBfo^AabTFe;^AcAgZ:[^AeJ7V=g^Aeh?1fC^"
    "AfjD>YO^Ag@ZenK^Aj`mimK^Ak[aR>G^AlPUVBK^AmkDfNW^An06J5G^AoH>6YC^B2[FV9_^"
    "B;AIn=K^B<cZ:Z[^B>CkFBW^BBkm697^BDbPFV_^BE3?>5O^BH1OFJ[^BLA96N?^BPhIBEW^"
    "BT[2nI?^BYBC:Y?^BZbH69[^B]iSF=C^Bc@Aj=c^BeYLmf7^Bf:R1n3^BgADf:O^BhB0JB[^"
    "Bn3Faf;^C29GQJc^C5`B>QG^C6Q@UfG^C7S7MV7pC:h0B?7^C?3:MbG^CF2m6B[^CFK36>G^"
    "CFbO:>c^CGHpIeW^CK;4elo^CK[^61S^CM1X6N[^CMZf^=O^COYWNV[^CPI9R^c^CQ3FaYg^"
    "CS`B6>G^CXHgmb3PCYhU20c^CZBg62W^C_ZGBMC^C`jaaQk^Ca2G=lg^ChX`fMG^Cl9D5nS^"
    "Cm@12A7^Cm`NjFc^Co8pEbG^D0`TB:[^D3@dEmg^D8Kib6W^D:K>VZ[^D;1Kei_^D<Pl^6G^"
    "D>X<^EO^DEJL:6?^DFi;N6;^DO1VnBS^DOSd9i_^DQ3E26?^DRRejQC^DSjef5[^DTHWR1_^"
    "DVXlN:[^DW:66MG^DY0YEjO^D[1KRbg^D`0>NB3^Db[C^2O^DcSEFbg^DgX85ao^Dj3`ImW^"
    "DkXc9jG^E0[72V[^E@hFIbC^ECSo]mW^EE3PV^c^EFQWaMc]EFcDN=O^EH@c6a?^EL1iUi_^"
    "EMQJJVk^EMYSn:G^EN@lRJc^EWAAmf7^EWR=2FO^EZ1nj>S^E_kEAF3PEdcL6NS^Edh=ZMo^"
    "EhI?9B;^F0:D69C^F2KO5n3PF3[aJBW^F3cjj2K^F4XLn>[^F6bDV>S^F8C1VJS^F9`nMUW["
    "F:iHmQg^F=2Fan[^F?@8VO;^F@Ii2>W^FC0NbRW^FDk;QmW^FGXPRMO^FHP8N5g^FPBSjEO^"
    "FPihb1O^FTP_NB[^FZ8I:9O^Fa@iEj3PFc[3Q][^FeJORRS^FeiS>EW^FiZc=mo^FjPcJIg^"
    "G2ab:FW^G3khFES^G;HW6Ac^G=C:F>W^G?JT:jo^GD2UjQO^GHXbMY_]GMH7Z1W^GN0T^9O^"
    "GNJJj9k^GT0DEfG^GUKMJ>[^GYCm69S^G[P=2FW^GpR>=b7^G]iG>:O^G^2166K^Gb`0ZIS^"
    "GcRnZV_^Ge081ek^Gfb7>2K^GhaL2FG^GlAWJMO^H8ho]nK^H9Y?^:[^H>IeQ]c^H@i3FEO^"
    "HBKfAEk^HBaXbBk^HE@N^6S^HFc_I]o^HFjN^NG^HI0<f>O^HMQ3^Fc^HMZHV6S^HNK]1J;V"
    "HOAY=Z3^HQR6Y^C^HXPOZ1g^HZKV6:7^Hp;4Amk^H_1DJB[^HcaF>=K^He;QJbg^HeSiJ6S^"
    "Hh[F]R3PHhkob9[^Hn1cAnW^Ho:Sb6[^I19@QQg^I1A`69_^I70f^=K^I7XMY^O^I=BG6BO^"
    "I>Ro69W^I?8jF=S^I@Ym5j7^IAjHjMK^ICbnFF[^IE[OEfK^IEi<2EK^IPQ6227^IQkeB;;^"
    "IS9YNBW^IS:K6=k^I[`NJEO^IaJaVBW^IbZ]f2G^Id1M:NS^Io38f:[^J1Bp:JW^J1KMb=o^"
    "J69_FQG^J6PeE^;^J8A]>fg^J?2_=bC^JFjQVAk^JHa4ejG^JJSNQUg^JL@VBno^JM@;R:S^"
    "JN8oVBS^JOS^fNO^JT;`Z=[^JY`2JUO^Jpacn=O^J]3XIN?^J_hEF>K^JdPG657^Jf[Y>5[^"
    "JiQiJNW^JlB2BVc^K6:[Ffk^K:j]:QO^K<Jb6=[^K>ScUb7^KDh[j=_^KG1]Mak^KG9fmf;^"
    "KHi^f6O^KIbJJFW^KK;g]RW^KO[`aj?^KR8:^Jc^KW3YJ6S^KX9ZYb?^K[be5N7^KpHJB;C^"
    "K_9MAbS^KcKTeiS^Kd`DRRg^KeBQaiW^Kh3M6>G^KnR26BW^KoC@^=S^L1SH9j3PL:1AmV?^"
    "L;Ho2<[^L;cA66O^LABaBAO^LBRa=lg^LBk7N9_^LECd=ZS^LH;<Qb7^LI1pB9O^LJ8IBZ_^"
    "LKI1BMG^LMPCJIG^LNZIVNc^LO@hj>_^LR1ki^O^LRXFZQG^LSAYb2K^LVaA5B3^LZ0Cb:W^"
    "L[HQB>W^L^[SnJ_^L`8V^=W^LbQkUiW^Lf2[1nS^Lg2f>2;^LjcmnR_^LkXTRJS^Ll8UnQK^"
    "LmK7^5O^M0R0nB_^M42NFNc^M5C6FAc^M5K?f1[^M5cV65[^M5i1Um_^M6jN]nO^M8AFR>_^"
    "M8bP6EO^M:Y3EjO^M>AOimK^MAPXN>3^MKX:Im_^ML20ZA[^MM9=:2;^MRCQ2VO^MVkRbMK^"
    "MW:>9N3pMX`8BJ_^M_X7mN7^M_a[:9g^MeR?n1g^MfR4VYC^Mfho>G3^Mh;Tn9_^MhC^RAS^"
    "Mii=6YK^MmRCUm_^MocE69W^N58UNUK^N78mmUg^N8i[mf?^N92W6BS^N984JR_^N@2CjMK^"
    "NAK_AB?]NFHWZIk^NI@dB9K^NKQoAn3PNPP9Ze7^NSIX:i7^NT3i5Yo^NUHDj2G^NU[a1io^"
    "N[k[RJ;^N_BKJBW^Nc:9NN[^Nci[V:S^NdPhbRS^NfSUR1[^Ni@jREO^Nj0HnUG^O1bmjEO^"
    "O;Xc:9W^O<9Bj=K^OBakNN[^OGIm>IK^OI@PNFW^OYief1S^OYimRQC^Op;0ieo^O]1169g^"
    "O]jhb2O^O`jn:o3^ObCgJY?^OeZojQO^Oj9NR6K^Ol8cF>_^Om:dQjG^OoXn^9S^P02dj=_^"
    "P1IT>6k^P2hCNAW^P5X^IfC^P=0W2F_^P=:XNAS^P>2X=^7^P?RK6:O^PBAB29?^PCh2Ve7^"
    "PD@JZIO^PFPR1fC^PJAf2>K^PLAlO0o^PWPE]Yg^PZII^2C^P[AY^VG^P[RFMR;^Pa06J9S^"
    "PbQMFIK^PdB2fBg^PhH9I]c^PhRh^FG^Po1M^FS^Q59`Z9C^Q:0iZ5o^Q:HE]mO^Q@Y^JBW^"
    "QAafiV3PQCQ^b6[^QD305EcXQEA`>=S^QF[kJZ[^QJC`]R7^QJPIb5[^QJ[nJJW^QJj;N1[^"
    "QKkXYjS^QRZ0Va;^QRb:65o^QTPeeUk^QXY@^=_^Q]H1f:O^Q]REEak^Q^ba66S^Q`;ZF]C^"
    "QcRbjEW^Qc`=RFg^QeCHJ>g^Qf[UeVC^QgQV2MG^QmJgjbc^Qn159Uc^R21P263^R3P?F;?^"
    "R4Z3NF_^R4be6=_^R6jTYVC^R9[iZUC^R=HhJJ3^REYg:FW^RJ9_J]?^RP[Rf:[^RRk6:JO^"
    "RX9?I^3^RYb7>^c^RbH:V>K^RcYn^5O^RjINf2O^RnhUR6S^S73P]b[^S7@Kb:3^S839jZ_^"
    "S;@LJYO^S@Q3^^g^SAH_FBS^SD2YB5o^SH@3>5W^SK:CJB[^SpK7:MO^S]k<6EW^S`@G9f7^"
    "Sc9mJEG^SdBGiRk^SfI5j=[^Sf[J^Z[^Shb@mf?^SiCF6BK^SkBZjRg^SkJdJFS^SoHaNEO^"
    "T1@:af?^T1`NEf3^T3IRFR[^T7JY2:O^T80bR>S^T8X3J2S^T>0dBCC^TE3nf5S^TGiMJAK^"
    "TJYhAj3PTM82N=G^TNhR61O^TP:L6N[^TPcZ^=W^TS3b9R?^TTSU26_^TVZpeA[VT]1I24c^"
    "T]K[::[^T_X<BAK^TaAp^6C^Tb8<M][^Td;;B4g^ToJSZ:S^U0BcZN[^U0iBjB_^U41kQQ_^"
    "U;XKaQS^UAa0b=W^UGS51nS^UIZAF1o^ULCVJMG^UR:JnF_^UR`X=e_^UUZhFF[^UVRWmZ_^"
    "UWQKV1k^UZBj:IO^UpCBUic^U_a8FN[^UbC2Aeg^Ue`7^6O^UgZZmYo^Um@TJES^V3ck2JK^"
    "V40f:1_^V8SlfEO^V8ZX9J3pV:k5VBK^V;ZW^2S^V<R_nMG^V@P]2>g^VDQ_mJK]VF2VQJKT"
    "VI[=J>O^VIco2A_^VIh8R9[^VMK?JFg^VXaGmMc^VZJ5mj7^VZR?M>;pVZ[16BK^Va1LUnS^"
    "Vb:=5VG^VdXOMn3PVeXpb>[^Vgh@6V[^Vh11^Ig^VjX6mF?^Vm:IAak^VmcT=^C^VnbA=bW^"
    "VoCG9^O^W1RXJaC^W3STn2?^W6JCF=O^W6h^n2?^W7IDNBS^W8@fV6?^W<1NaZ;^W<:cZQK^"
    "W=P5RJ7^W@C^1Z;^WCi_N:[^WF9BbRK^WH3oR1S^WJaDVEK^WKXlN1k^WTJJj2_^WVIiBBO^"
    "WWYSNB[^WYXhBFS^W]S[N>S^WdB3IM[YWdK76AK^Wf8h^IK^Wi2GBIO^WjAc5b?^WmYWN=K^"
    "X11=J<k^X;J?f1O^X=[E6Fo^X>HP2Nc^X>QK65k^X?Y82AS^X@KnF>W^XA8Xj^c^XBSH:fg^"
    "XFAD]b?^XFaX=ic^XN[>QfG^XPHBUZ3^XQ9H^9_^XS1n=ng^XTH]NAS^XY[BR9[^X^Y12N_^"
    "X_A[VZW^X_[2=f7^Xa:e:6O^XehdZIK^Xi:DZ_3^Xkj@26C^XoJKJQK^Y0ReiYo^Y1SLiNK^"
    "Y4XfYZS^Y90_]b7^Y:1FaQo^Y:2VVMG^Y<b3^BS^Y@PXFB[^YARYUYc^YD1gF=O^YEjLfFg^"
    "YJ3B^V[^YJYOn5_^YN87FAG^YPYg^JK^YSRejAO^YShp:9g^YZhG5R3PYb:8NBW^YcJ@iN;X"
    "Yd0[ZAS^Yfj:>AW^Yhh0e]W^Yl0cb9c^YlRUR5W^Z5j`bUK^Z8:<JEK^Z:9Z^5_^Z<j]]jW^"
    "Z>HZVUG^Z?b61jC^ZA[c:5W^ZB@@9aS^ZE3<jEO^ZI206EG^ZIXeI^G^ZSYj25k^ZWcP>9O^"
    "Zp3cieg^Z]9NRV_^Z^X=fb?^Z^iBJEo^Z_hefMW^ZaYER5S^ZecQj6K^Zg27Zfk^Zg:A:FG^"
    "ZhB_ZUC^Zhc?IaS^Zkb9JQO^ZmJOVYG^[1A9=eC^[2;lf:W^[4KP:FK^[4PAb9o^[5hIJY;^"
    "[81C=Ik^[FRHYnG^[Kihf6W^[LbJjB?^[PK1bFO^[QAcV:;^[RaDNF7^[WHTZ9[^[[;>B=G^"
    "[]99NIS^[_bNNIO^[c19F:G^[i`MB5[^[l;]^bc^[lZ]JBS^p<@MVIG^p=Hh1J;^p>3Q:MK^"
    "pH1On=c^pJBZmf?^pJk`6JO^pLS8J>[^pMBZQnW^pV9bb^g^pViDjVc^pWSR:9K^p_Q>B;C^"
    "pa[Kn5g^pc`HMj3Ppf:RZIC^pfXHf1_^pk1gf=S^pl:BER;^po8l>IK^]0Hl9mc^]1Zf6J_^"
    "]2H4^EW^]2YOInO^]3`<JIK^]6;o26S^]<@9bR[^]<RD^5c^]?05::[^]@kInRc^]E[UB4_^"
    "]MYQZBG^]Q2mZ6O^]RIpjBc^]Y31BQ?^]]97f:S^]aQVfR[^]a`H2Bg^]j3P^N_^^0Skb5[^"
    "^0ZMUm[^^2`;^:O^^3ZdnF[^^40CEjC^^4A2=i_^^6X5:J_^^7;BFB_^^91eUmk^^:3B^2G^"
    "^;kD:EO^^<IKU^3P^=agEnG^^=kpV1[^^@iDYUk^^CkLB1[^^DkEIFG^^GHQ^2O^^KS[nNS^"
    "^N`nNIK^^Q:S>6W^^Qa8EN;^^SHJf6C^^T1UbR_^^UHE2RO^^Z8FfMK^^ZR=2:K^^l`Z:I7^"
    "_0[7V5_^_3X_YFG^_6ZOImG^_:;l^BW^_;8XBNS^_<2Omf?^_<;K6JS^_=boYn3P_=idb1O^"
    "_>kAibW^_Fj4J6O^_S32NYK^_WJ45mO^__8ORF3^_a0^MQW^_gYpbR[^_lI^VAK^_mAFN1k^"
    "`4kajAS^`5j3FAO^`9AmN>S^`:P3^=W^`;9BFFG^`=9H^]?^`>aW:5W^`Ej_NZ[^`JRaBIO^"
    "`O:1N1C^`TP`2AO^`VYX2MK^`]2Yf5O^`_Cdib;^`a3pb6W^`d[MUag^`eRC66K^`ga^]fC^"
    "`j39n6C^`oAWF:[^a0CXUbG^a2ab^5[^a4RH>2k^a617NA[^a8Y:Qj?^a8aRI^C^a;;pRE_^"
    "a@9K2F[^a@CLN5W^aB9o^2_^aB[?:2K^aDiLf1;^aGI>ZI[^aIYF5V;^aJSiQ^K^aK`Z62S^"
    "aLkR^2C^aMJZ2>[^aM[FeVo^aR;?ibG^aSRlmm7^aT1?6J[^aT:Siik^aWk@Yj;^aZY9]Z7^"
    "a^BD>Zg^a^JM^>C^ac1]j:O^aeZAFES^agJffFg^ak[p^R[^anR1J6[^ao`QF=K^b2:AbFO^"
    "b42g=R3Pb5Z_:6W^b<Pa5US^b>8XmjK^b@3[bM?^bCbRNBK^bE3:N1_^bHJT>=W^bJa]26K^"
    "bMY=f9[^bXhV>9c^bYZVJAS^b[b4^9W^bakU:RW^bcb8F5S^bg1TeV;^bhP<J>[^bjZJ6IK^"
    "bnX55N3[c5:D61g^c7bgRBG^c7kY6=c^c9CjB1S^c<YjZIK^c>ahRV[^c?2m:2[^c@QpNAg^"
    "cC9_R5S^cGCkj:O^cHb[:BK^cQ3Yiak^cR`aZfk^cS`Ff6O^cV3j>FO^cV8[bF7^cYY]=Ik^"
    "c`@=^i?^ccSc]Uo^cfHPZJ[^cmRBf6S^d2b=VBS^d49YN=[^d9XM2YK^d<Zf^^k^d>YSNAW^"
    "dKHgB9[^dNC7JJ[^dT15j6W^dVSH=J7^dXXF6F_^d_8gR4o^d_Sk:IO^d`c=QR7^daajQZO^"
    "dbC0MBGZdeJM^2O^deYXU^O^djHmbJS^dk@OjNc^dlP:6>W^do185MoZe4iBEj;^e5:o2=G^"
    "e<bhYf3Pe=`mfQG^eA9XB;G^eE@bMV7^eGblZAO^eKcoUZS^eOQgZ1S^ePSDb:S^ePXTVJS^"
    "eR1F9mk^eRK7f1_^eSC@:R[^eT0NbAW^eU:TnFc^eU@VJAO^eW`I66K^eXR7=bG^eY8R2a;^"
    "ep20Ve7^e]ALIN;^eahpUf?^ebKcn>[^egCoB4W^ehX6j9C^ei26miW^f1H9B^c^f2SGZ:K^"
    "f2XaFUG^f3KWZJ[^f88=Mb3^f9aAR5O^f:[KBEO^f<CaJ9c^f>aQf6S^fB0F=Y[^fDa[AeS^"
    "fR:gUi[^fUC>n>S^fUiL=i_^fXcpFF_^fYkdeY_^fZZ?V1k^f[[p^6K^f]K^:AK^f^1eU1gV"
    "ffAfN=_^fhhkanG^fjkXQVC^fk082=_^fm2?je7^fn[`F5W^g0IHNMW^g6CPMn7^g70_2NO^"
    "g;X`fMK^g=Y9B1O^g?IgAfG^g?X?b>c^gFRO>QG^gKZ=B6k^gLc?eRO^gLhc2=g^gW0DnM;^"
    "gYicRaC^g]ce6FS^giZDf>S^gk146JW^gk9e^E_^h0PTB=O^h@XiVIc^hG2SN6W^hIB6bNS^"
    "hK@cR5W^hMj8V=[^hQ[^V=K^hSZ]Ij3^hVP;jEO^hYR]BBS^hZ1`n^k^h[BHnYC^hpapF>W^"
    "h`J1>5S^h`J8j]C^hgK9Nbc^hhh2^e?^hl;;BES^i69:29O^i9iN6:S^i>S3j5S^i@h>i^7^"
    "iBX6f:[^iCPbFB_^iIJ8]fG^iJH=n]C^iN:gV=G^iPb1J>W^iRb7be7^iTB<^9W^iV:b>6o^"
    "iVRoj27^iWQQNAW^ip`6VES^i`3e66_^iaae2F[^ibcfAbC^idCY:2O^ifIff=;^ifafmJK^"
    "igPAaeS^ih@J2Vc^ihQ^i^G^ii1XZIO^ikA`5^C^io346BW^io@6jUK^j12l9MkVj3[YibC^"
    "j5;G1m3^j5QY6JS^j<A9=e3^j?jg^:C^j@BCfBc^jDR7j:K^jGXQV2O^jI3@fJ_^jIhn>bc^"
    "jJS;MMc[jM9GIR3PjM@6bFS^jQ@9bRW^jSb[bBW^jUSAAU[^jY:;nQC^jYBEN=g^jYjn^9O^"
    "j[11=Yg^jb;mJ:O^jeBlN>S^jf[e^]C^jj2n>=W^jj@HjBc^jjjV9iW^jlJ72:S^jo9Wf5[^"
    "joI<NFS^jo[IR1_^joi6>E_^k3k3Bbk^k4Q@Qao^k72PV6S^k;C0JIc^k=BNb9_^k@8521S^"
    "kEJRJ5W^kJ0VJFW^kL2ZVQG^kL:d6EK^kP8a:>_^kPYjbY;^kTQ@:fg^kVb^5mc^kYKARBO^"
    "kYP36=o^k]3:2bg^k`BBVJ[^kb26NEc^kcSU6IO^kdb9R1W^khhEj:S^kj::65S^kjC5:BG^"
    "l2X3ib7^l2`=I]c^l:H;1V?^l;:7AAk^l>SEBno^lA`Wbi7^lG1?737^lG9HV:K^lG`a:Ng^"
    "lGhj^N_^lKIDJ1W^lO2pj2O^lSQcRFO^lUZ3NF3^lZRjRJ[^l[@g6YC^l^C@^R[^lcbjImg^"
    "ldYp>V[^liZ8^E?^lliAB=_^lm;V2^c^loYhIEc^locQJFW^m19[F:S^m1bf>Nc^m3@c5I[T"
    "m5hlf9c^m9i]^Vg^m:1g=j;^m>Pmj:W^m@YAR8g^mA8E>MO^mN0T6BW^mSX=b9K^mUiHeb3P"
    "m]:h9Q[^m^KBYZ7^mbZ2BCK^md9;EjW^mhXGe]_^miCFZ=S^n4cZ:F[^n6bnnF[^n8jHbR[^"
    "n=RJVe?^nB8W9Mc]nB8i::C^nFklF9O^nGPIFEK^nHhIBEg^nPRlJ>7^nRca^9O^nT;aYnG^"
    "nXZVBB_^nY0fBIO^np;eBIK^n]2cA^G^n`Akf6S^nbcMj1_^nfACZ6S^nl@C6:K^o32E1Qc^"
    "o3cAV9[^o78Ea63Ro7If=i_^o8iG6:K^o:H6J:_^o;P>eYg^o<:YV1g^o>`CJ6g^o?08:EK^"
    "oAK@n6S^oD28YUo^oG0hJV_^oG:=>:S^oJAZQ^?^oJQEb2K^oK1kEVC^oOR:9f;^oSkJbR[^"
    "oXQ96NS^oYaa6=c^o]A:f9K^o_ASAiS^oa;n2IK^oei`1NG^of8ji^O^ogCJfAG^ohZHMfO^"
    "ojaTbES^onQ=2A_^00001V3P0200023P02T0023P04401>3P04P0123P06400>3P06P0063P"
    "08X00:3P09000:3P0R000B3P0RT00>3P0Y000J3P1200023P12T00>3P13<00B3P13X00>3P"
    "16P00J3P17800F3P1;000J3P1R00023P1RT00>3P1VP00B3P22000:3P3200063P3R00063P"
    "40000F3P42000J3P44400:3P44P00B3P5;000B3P8Y000J3P<4400J3P@000023P@200063P"
    "A2000F3PAR000>3PB2000:3PH0000B3PH2000N3PL0000:3PL2000>3PP200123PP6400j3P"
    "P6P01n3PP8X00F3PP900023PP:X00J3PP;000>3PPR001V3PPY000F3PQ0001V3PQ1<01J3P"
    "Q1X01>3PQ200163PQ3<01V3PQ3X01B3PQ4P01b3PQ5801F3PQ640123PQ7801^3PQ9000:3P"
    "Q;00063PQP001N3PQPT01J3PQR001F3PQRT01^3PQTP01>3PQVP01V3PR2001J3PR8X00J3P"
    "R9000:3PS0001:3PS1<01>3PS1X0163PS5801:3PS9000>3PSP001B3PSPT01N3PSTP01J3P"
    "T6400n3PT9000J3PU5801N3PU6400j3PU6P01F3PU9000:3PU;000>3PUTP0123PUV401B3P"
    "W9000F3PW=400J3PWT401Z3PX8X00N3PX9000N3PXY000F3PX[000>3PY9000B3PZ8X00N3P"
    "ZY000R3P[8X00R3P[9000B3P[X<00V3P]6400R3P`2000j3P`9000N3Pa200163Pa5801>3P"
    "a9000Z3Pc0001F3Pc5801J3PcP001b3Pe9000R3Ph8X00N3Ph9000J3Ph:X00R3Pi9000B3P"
    "iZ<00N3Pj8X00R3Pk900063PkP000B3Pl2000N3Pm1<00R3Pm2000N3PmP000B3PmR000J3P"
    "o0000:3Po1<00J3PoP00063P0F@0163P0a@00R3P0n@0123P16P00n3P1<000V3P1C@0163P"
    "1O@01R3P1`@00V3P1d@00n3P1o000Z3P26@00V3P2O@0163P2Y@00^3P2n`00F3P39@00b3P"
    "3RP00V3P3]@01:3P3`00023P3a000^3P48000B3P4=P0123P4=`00b3P55001J3P5WP00n3P"
    "5c`00^3P5hP00V3P6hP00^3P6h`00F3P6m`00B3P7IP01F3P7Q`00j3P7iP00R3P7o@00V3P"
    "87P00J3P8@P00R3P8DP00^3P8[`00j3P8_@0123P8n000Z3P9D@00b3P9N000N3P9U@00f3P"
    "9pP00^3P:1`00V3P:2P00n3P:2`00n3P:MP01Z3P;2@00N3P;C@01>3P<E@00b3P<Q@00^3P"
    "=NP00b3P>pP00:3P?P001>3P?n001B3P@5`01F3P@D@00^3P@]P00R3P@j00163PA8P00F3P"
    "B0@00Z3PB5P00N3PBC000V3PBH`0163PBK`0123PBW@0163PB^`00Z3PBfP00n3PCYP00f3P"
    "CcP01V3PCh001:3PDR@00R3PDZ`00>3PEE001N3PE`@00f3PEg`00Z3PFV001>3PF]@01B3P"
    "Fh`00J3PHM@00R3PH[`00Z3PHi000^3PHoP00N3PI7P00^3PIH`00Z3PIQP00R3PIWP00^3P"
    "JQP00j3PK0001B3PK7`00b3PK<`00j3PK?`0163PLPP00N3PLWP00j3PLY000N3PLgP0163P"
    "MCP01j3PN9@00f3PN?001N3PNSP01F3PNb00163PNmP0163POG000V3POI@00b3POW`00F3P"
    "Oi001J3PPQP0123PQB00123PRQ@00>3PR`P00V3PS9@00B3PSIP01N3PS]P00B3PT0`00j3P"
    "TN`00b3PU0P00N3PU3P01J3PU?000j3PUK`01F3PUi@00B3PVQP00j3PV`000^3PVaP00V3P"
    "Wb@00B3PX0`00:3PX=@00^3PYRP00^3PYf`01^3PZ9@00^3P[9P00R3P[B`00^3P[G`00b3P"
    "[P`00Z3P[b`01F3Pp=P00V3PpJ000Z3Pp^000Z3Ppg`0163PplP00N3P]500123P^BP00J3P"
    "^DP00f3P^^@01V3P_NP00V3P_T@00^3P`J000^3P`V@00f3Pa1@01>3Pb8001j3Pc>@00R3P"
    "c``00^3Pcj`00f3Pd;`01B3PdO000b3PdV`0163Pdb000R3Pe=000J3Pe@`00Z3PeF`01V3P"
    "eK`00Z3PeS000b3PeY000F3Pe_P00N3Pen000>3PfN000b3PfpP00j3Pg8000j3Pge`00V3P"
    "h4@0163PhH000F3Phc000F3PiJ@00f3PiS@00V3PiX@00^3Pim@01>3Pj200163PjA000n3P"
    "jQ@01R3PjU`00V3Pjo@00Z3Pk=`00R3PkD000b3PkG000>3Pk]@00J3Pl?`00>3PlT`00n3P"
    "lY000Z3Plp001^3PlgP00R3Pn2000b3Pn:P00N3PnF001J3PoB000b3PoPP00j3P0J000V3P"
    "0PP01F3P0W000f3P0[000V3P0]001:3P15`00n3P1M`00n3P1Q000R3P1c@00j3P1g`00j3P"
    "1j`00n3P29001>3P2FP0163P2MP00f3P2V@00R3P31`00f3P36P00b3P3e000j3P41P00f3P"
    "4E`00j3P4H@00f3P4J000f3P4pP00n3P4o000B3P53`00b3P56P00Z3P5D000j3P5EP00n3P"
    "5P000V3P5S00123P5VP00b3P5XP00b3P5f`00j3P5l00123P5m@00n3P66@00Z3P6>P00j3P"
    "6J`00n3P6Q000^3P6S000f3P6Y`00b3P6a@00j3P6l@00n3P7BP00f3P7JP00n3P7U000V3P"
    "87001B3P8k000j3P8l000b3P9;@00f3P9O`01R3P9YP00b3P9Y`00j3P9g001V3P9oP00^3P"
    ":6`01Z3P:S@01F3P:V000n3P:Y000^3P:[P01F3P:l`01:3P:m000f3P;AP00f3P;O001:3P"
    "<8000F3P<?@00f3P<V000b3P<i000Z3P==P0123P=C000j3P=CP00^3P=Q001:3P=R`01>3P"
    "=S001R3P=p`00j3P=`@00f3P=lP00V3P>8000j3P>]000n3P>mP00F3P?]`01:3P@V`00j3P"
    "@`P0123P@b@00b3P@cP0123P@mP00b3PA[000^3PB3`0123PB4`01:3PB9000^3PB=@00b3P"
    "Bg000f3PC8@0123PCI@01:3PCWP00J3PC_000n3PCfP00V3PCnP01>3PD5P00j3PD=000n3P"
    "DE001F3PDE@00f3PDjP00R3PE2@01V3PEH000f3PEI`00f3PE_@00f3PF0000f3PFG000f3P"
    "FM@00Z3PFO@00n3PFe@00f3PG9@0123PG?P00f3PGG`00^3PGW`01:3PG[`00n3PG^@00j3P"
    "Gj@01V3PHI001F3PHZ@00^3PHg@00b3PIj@00n3PJQ000f3PJX@00j3PJl@00f3PKD000j3P"
    "KV@01>3PKX`00b3PL6`0163PL;`01:3PLA@00^3PLS000Z3PM7000f3PM@P00V3PMC@0163P"
    "MX`00f3PMj@00f3PMkP00b3PN6P00j3PN=`01:3PNK@00^3PNZ`00j3PN[@0123PN_P00f3P"
    "NiP01B3PNm`00b3PO>@01R3POBP00^3POF`0163POS`00f3POX@00b3POc`01R3POg000j3P"
    "P<000j3PPA@00^3PPS`00n3PP]@00n3PQG`01:3PQJ@01:3PQK000^3PQO@00f3PQU`00V3P"
    "R3000j3PRU`01N3PRc`00J3PRe`00f3PRl`00f3PS0@0163PS7`00V3PS8@00n3PSJP00V3P"
    "SL@00j3PSMP01J3PSOP00R3PSU000b3PT0@00N3PT;@01F3PTO000n3PTTP00f3PTVP00^3P"
    "T``00V3PTcP00^3PTe`00Z3PTm`00n3PU0@00N3PUL00123PUM@0123PUQ000V3PUS000V3P"
    "V7@00f3PVEP01B3PVE`00f3PVF`0123PVG`00V3PVI`00n3PV`P00^3PW5P0123PW7@00^3P"
    "W>`0123PW?@00^3PWJ`01R3PWR`00j3PWmP00n3PX:P00f3PXA@00Z3PXI@00f3PYL`0123P"
    "Yi`00n3PZC@00j3PZP@00b3PZiP0123PZi`01:3PZn@00Z3P[5@0163P[?@0163P[H`00n3P"
    "[Y000V3P[Z@00Z3P[j@00b3P[k`00j3PpiP00b3P]@000j3P]I00163P]]P00n3P^B@0123P"
    "^CP00f3P^FP00n3P^N000b3P^OP01B3P^Q000f3P^X000j3P^pP00b3P^k000J3P_9`00b3P"
    "_DP01:3P_R@00R3P_d`00f3P`4P00n3P`9`01>3P`R00123Pa8P01J3Pa[`00^3Pa`P01:3P"
    "bT`00:3PcI@01:3PcI`00Z3Pc[000N3Pc]`01J3PcoP00b3Pd2001:3Pd7000^3PdDP01>3P"
    "dV@00V3Pe000123PeH`0163PeK`00^3Pe`000^3PejP01F3PelP00b3Pf4000j3Pf@000f3P"
    "fA001B3PfGP00j3PfH@00f3PfM000n3PfQP00b3PfV@00^3Pfc000R3PflP00f3Pfn000j3P"
    "fo000^3Pg3P00j3PgL000V3Ph1@00:3Ph3P01F3PhR`0123PhY`0123Phi`00f3PiRP00b3P"
    "iY000Z3PiYP00b3PipP0123Pi`@0223PieP01>3PjC`00n3PjJ001:3PjV`00f3Pji000n3P"
    "k1000N3PkT@00^3Pl8@00f3Pl:`00Z3Pl?`0163PliP00b3PlkP0123Pm:@00Z3Pm:P00f3P"
    "me`01>3Pmh`00^3Pn<`0163Pn>@00j3Pn?P00b3PnYP00^3Po4P00b3Po5@00j3Po<@0123P"
    "oC000^3PoD000^3PoE@00j3Po`@00V3PobP01B3Pol@00n3P"
    "";

const std::array<std::array<std::int16_t, 32>, 2> kTurnWeights = {{
    {637, 1081, 291, 1257, 1923, 827, 1004, 413, 730, 818,
     683, 426, 257, 852, 0, 0, -411, -490, -513, -987,
     -685, -246, -159, 463, -174, -518, -417, 257, -131, -131,
     -131, -131},
    {1104, 1072, 340, 1102, 1470, 1140, 1297, 731, 480, 939,
     1050, 702, -136, 0, 0, 0, -282, -161, -227, -611,
     -415, -204, -169, 233, 12, -553, -302, 87, -28, -28,
     -28, -28},
}};

const std::array<std::array<std::int16_t, 8>, 1> kStartWeights = {{
    {1835, 1548, 1214, 0, 0, 0, 0, 0},
}};

const std::array<std::array<std::uint16_t, 2>, kFlags> kFlagStart = {{
{47, 20},
{47, 20},
{47, 20},
{47, 20},
{47, 20},
{47, 20},
{47, 20},
{47, 20},
{80, 20},
{80, 20},
{80, 20},
{80, 20},
{80, 20},
{80, 20},
{80, 20},
{80, 20},
{122, 20},
{122, 20},
{122, 20},
{122, 20},
{122, 20},
{122, 20},
{122, 20},
{122, 20},
{289, 20},
{289, 20},
{289, 20},
{289, 20},
{289, 20},
{289, 20},
{289, 20},
{289, 20},
{41, 20},
{41, 20},
{41, 20},
{41, 20},
{41, 20},
{41, 20},
{41, 20},
{41, 20},
{398, 20},
{398, 20},
{398, 20},
{398, 20},
{398, 20},
{398, 20},
{398, 20},
{398, 20},
{316, 20},
{316, 20},
{316, 20},
{316, 20},
{316, 20},
{316, 20},
{316, 20},
{316, 20},
{803, 20},
{803, 20},
{803, 20},
{803, 20},
{803, 20},
{803, 20},
{803, 20},
{803, 20},
{204, 16},
{204, 16},
{204, 16},
{204, 16},
{204, 16},
{204, 16},
{204, 16},
{204, 16},
{1208, 20},
{1208, 20},
{1208, 20},
{1208, 20},
{1208, 20},
{1208, 20},
{1208, 20},
{1208, 20},
{19, 20},
{19, 20},
{19, 20},
{19, 20},
{19, 20},
{19, 20},
{19, 20},
{19, 20},
{2328, 20},
{2328, 20},
{2328, 20},
{2328, 20},
{2328, 20},
{2328, 20},
{2328, 20},
{2328, 20},
{1636, 20},
{1636, 20},
{1636, 20},
{1636, 20},
{1636, 20},
{1636, 20},
{1636, 20},
{1636, 20},
{156, 20},
{156, 20},
{156, 20},
{156, 20},
{156, 20},
{156, 20},
{156, 20},
{156, 20},
{201, 20},
{201, 20},
{201, 20},
{201, 20},
{201, 20},
{201, 20},
{201, 20},
{201, 20},
{1618, 20},
{1618, 20},
{1618, 20},
{1618, 20},
{1618, 20},
{1618, 20},
{1618, 20},
{1618, 20},
{28, 20},
{28, 20},
{28, 20},
{28, 20},
{28, 20},
{28, 20},
{28, 20},
{28, 20},
{131, 20},
{131, 20},
{131, 20},
{131, 20},
{131, 20},
{131, 20},
{131, 20},
{131, 20},
{315, 20},
{315, 20},
{315, 20},
{315, 20},
{315, 20},
{315, 20},
{315, 20},
{315, 20},
{521, 20},
{521, 20},
{521, 20},
{521, 20},
{521, 20},
{521, 20},
{521, 20},
{521, 20},
{343, 20},
{343, 20},
{343, 20},
{343, 20},
{343, 20},
{343, 20},
{343, 20},
{343, 20},
{649, 20},
{649, 20},
{649, 20},
{649, 20},
{649, 20},
{649, 20},
{649, 20},
{649, 20},
{660, 20},
{660, 20},
{660, 20},
{660, 20},
{660, 20},
{660, 20},
{660, 20},
{660, 20},
{1704, 20},
{1704, 20},
{1704, 20},
{1704, 20},
{1704, 20},
{1704, 20},
{1704, 20},
{1704, 20},
{144, 20},
{144, 20},
{144, 20},
{144, 20},
{144, 20},
{144, 20},
{144, 20},
{144, 20},
{43, 20},
{43, 20},
{43, 20},
{43, 20},
{43, 20},
{43, 20},
{43, 20},
{43, 20},
{498, 20},
{498, 20},
{498, 20},
{498, 20},
{498, 20},
{498, 20},
{498, 20},
{498, 20},
{4059, 20},
{4059, 20},
{4059, 20},
{4059, 20},
{4059, 20},
{4059, 20},
{4059, 20},
{4059, 20},
{2495, 20},
{2495, 20},
{2495, 20},
{2495, 20},
{2495, 20},
{2495, 20},
{2495, 20},
{2495, 20},
{252, 20},
{252, 20},
{252, 20},
{252, 20},
{252, 20},
{252, 20},
{252, 20},
{252, 20},
{1429, 20},
{1429, 20},
{1429, 20},
{1429, 20},
{1429, 20},
{1429, 20},
{1429, 20},
{1429, 20},
{4994, 20},
{4994, 20},
{4994, 20},
{4994, 20},
{4994, 20},
{4994, 20},
{4994, 20},
{4994, 20},
{101, 20},
{101, 20},
{101, 20},
{101, 20},
{101, 20},
{101, 20},
{101, 20},
{101, 20},
{422, 20},
{422, 20},
{422, 20},
{422, 20},
{422, 20},
{422, 20},
{422, 20},
{422, 20},
{679, 20},
{679, 20},
{679, 20},
{679, 20},
{679, 20},
{679, 20},
{679, 20},
{679, 20},
{1647, 20},
{1647, 20},
{1647, 20},
{1647, 20},
{1647, 20},
{1647, 20},
{1647, 20},
{1647, 20},
{1235, 20},
{1235, 20},
{1235, 20},
{1235, 20},
{1235, 20},
{1235, 20},
{1235, 20},
{1235, 20},
{1402, 20},
{1402, 20},
{1402, 20},
{1402, 20},
{1402, 20},
{1402, 20},
{1402, 20},
{1402, 20},
{2649, 20},
{2649, 20},
{2649, 20},
{2649, 20},
{2649, 20},
{2649, 20},
{2649, 20},
{2649, 20},
{5331, 20},
{5331, 20},
{5331, 20},
{5331, 20},
{5331, 20},
{5331, 20},
{5331, 20},
{5331, 20},
{4296, 20},
{4296, 20},
{4296, 20},
{4296, 20},
{4296, 20},
{4296, 20},
{4296, 20},
{4296, 20},
{3378, 20},
{3378, 20},
{3378, 20},
{3378, 20},
{3378, 20},
{3378, 20},
{3378, 20},
{3378, 20},
{5182, 20},
{5182, 20},
{5182, 20},
{5182, 20},
{5182, 20},
{5182, 20},
{5182, 20},
{5182, 20},
{8832, 20},
{8832, 20},
{8832, 20},
{8832, 20},
{8832, 20},
{8832, 20},
{8832, 20},
{8832, 20},
{13815, 20},
{13815, 20},
{13815, 20},
{13815, 20},
{13815, 20},
{13815, 20},
{13815, 20},
{13815, 20},
{9844, 20},
{9844, 20},
{9844, 20},
{9844, 20},
{9844, 20},
{9844, 20},
{9844, 20},
{9844, 20},
{13774, 20},
{13774, 20},
{13774, 20},
{13774, 20},
{13774, 20},
{13774, 20},
{13774, 20},
{13774, 20},
{15000, 20},
{15000, 20},
{15000, 20},
{15000, 20},
{15000, 20},
{15000, 20},
{15000, 20},
{15000, 20},
{132, 20},
{132, 20},
{132, 20},
{132, 20},
{132, 20},
{132, 20},
{132, 20},
{132, 20},
{150, 20},
{150, 20},
{150, 20},
{150, 20},
{150, 20},
{150, 20},
{150, 20},
{150, 20},
{271, 20},
{271, 20},
{271, 20},
{271, 20},
{271, 20},
{271, 20},
{271, 20},
{271, 20},
{545, 20},
{545, 20},
{545, 20},
{545, 20},
{545, 20},
{545, 20},
{545, 20},
{545, 20},
{2020, 20},
{2020, 20},
{2020, 20},
{2020, 20},
{2020, 20},
{2020, 20},
{2020, 20},
{2020, 20},
{1459, 20},
{1459, 20},
{1459, 20},
{1459, 20},
{1459, 20},
{1459, 20},
{1459, 20},
{1459, 20},
{2018, 20},
{2018, 20},
{2018, 20},
{2018, 20},
{2018, 20},
{2018, 20},
{2018, 20},
{2018, 20},
{3254, 20},
{3254, 20},
{3254, 20},
{3254, 20},
{3254, 20},
{3254, 20},
{3254, 20},
{3254, 20},
{2845, 20},
{2845, 20},
{2845, 20},
{2845, 20},
{2845, 20},
{2845, 20},
{2845, 20},
{2845, 20},
{2983, 20},
{2983, 20},
{2983, 20},
{2983, 20},
{2983, 20},
{2983, 20},
{2983, 20},
{2983, 20},
{2953, 20},
{2953, 20},
{2953, 20},
{2953, 20},
{2953, 20},
{2953, 20},
{2953, 20},
{2953, 20},
{5380, 20},
{5380, 20},
{5380, 20},
{5380, 20},
{5380, 20},
{5380, 20},
{5380, 20},
{5380, 20},
{6718, 20},
{6718, 20},
{6718, 20},
{6718, 20},
{6718, 20},
{6718, 20},
{6718, 20},
{6718, 20},
{5123, 20},
{5123, 20},
{5123, 20},
{5123, 20},
{5123, 20},
{5123, 20},
{5123, 20},
{5123, 20},
{6298, 20},
{6298, 20},
{6298, 20},
{6298, 20},
{6298, 20},
{6298, 20},
{6298, 20},
{6298, 20},
{8704, 20},
{8704, 20},
{8704, 20},
{8704, 20},
{8704, 20},
{8704, 20},
{8704, 20},
{8704, 20},
{483, 20},
{483, 20},
{483, 20},
{483, 20},
{483, 20},
{483, 20},
{483, 20},
{483, 20},
{1025, 20},
{1025, 20},
{1025, 20},
{1025, 20},
{1025, 20},
{1025, 20},
{1025, 20},
{1025, 20},
{1786, 20},
{1786, 20},
{1786, 20},
{1786, 20},
{1786, 20},
{1786, 20},
{1786, 20},
{1786, 20},
{2644, 20},
{2644, 20},
{2644, 20},
{2644, 20},
{2644, 20},
{2644, 20},
{2644, 20},
{2644, 20},
{3536, 20},
{3536, 20},
{3536, 20},
{3536, 20},
{3536, 20},
{3536, 20},
{3536, 20},
{3536, 20},
{1366, 20},
{1366, 20},
{1366, 20},
{1366, 20},
{1366, 20},
{1366, 20},
{1366, 20},
{1366, 20},
{2782, 20},
{2782, 20},
{2782, 20},
{2782, 20},
{2782, 20},
{2782, 20},
{2782, 20},
{2782, 20},
{4680, 20},
{4680, 20},
{4680, 20},
{4680, 20},
{4680, 20},
{4680, 20},
{4680, 20},
{4680, 20},
{5398, 20},
{5398, 20},
{5398, 20},
{5398, 20},
{5398, 20},
{5398, 20},
{5398, 20},
{5398, 20},
{2355, 20},
{2355, 20},
{2355, 20},
{2355, 20},
{2355, 20},
{2355, 20},
{2355, 20},
{2355, 20},
{3664, 20},
{3664, 20},
{3664, 20},
{3664, 20},
{3664, 20},
{3664, 20},
{3664, 20},
{3664, 20},
{5279, 20},
{5279, 20},
{5279, 20},
{5279, 20},
{5279, 20},
{5279, 20},
{5279, 20},
{5279, 20},
{9947, 20},
{9947, 20},
{9947, 20},
{9947, 20},
{9947, 20},
{9947, 20},
{9947, 20},
{9947, 20},
{3229, 20},
{3229, 20},
{3229, 20},
{3229, 20},
{3229, 20},
{3229, 20},
{3229, 20},
{3229, 20},
{4341, 20},
{4341, 20},
{4341, 20},
{4341, 20},
{4341, 20},
{4341, 20},
{4341, 20},
{4341, 20},
{6081, 20},
{6081, 20},
{6081, 20},
{6081, 20},
{6081, 20},
{6081, 20},
{6081, 20},
{6081, 20},
{585, 20},
{585, 20},
{585, 20},
{585, 20},
{585, 20},
{585, 20},
{585, 20},
{585, 20},
{2172, 20},
{2172, 20},
{2172, 20},
{2172, 20},
{2172, 20},
{2172, 20},
{2172, 20},
{2172, 20},
{5034, 20},
{5034, 20},
{5034, 20},
{5034, 20},
{5034, 20},
{5034, 20},
{5034, 20},
{5034, 20},
{8122, 20},
{8122, 20},
{8122, 20},
{8122, 20},
{8122, 20},
{8122, 20},
{8122, 20},
{8122, 20},
{4530, 20},
{4530, 20},
{4530, 20},
{4530, 20},
{4530, 20},
{4530, 20},
{4530, 20},
{4530, 20},
{3932, 20},
{3932, 20},
{3932, 20},
{3932, 20},
{3932, 20},
{3932, 20},
{3932, 20},
{3932, 20},
{7917, 20},
{7917, 20},
{7917, 20},
{7917, 20},
{7917, 20},
{7917, 20},
{7917, 20},
{7917, 20},
{14392, 20},
{14392, 20},
{14392, 20},
{14392, 20},
{14392, 20},
{14392, 20},
{14392, 20},
{14392, 20},
{14200, 20},
{14200, 20},
{14200, 20},
{14200, 20},
{14200, 20},
{14200, 20},
{14200, 20},
{14200, 20},
{6231, 20},
{6231, 20},
{6231, 20},
{6231, 20},
{6231, 20},
{6231, 20},
{6231, 20},
{6231, 20},
{9041, 20},
{9041, 20},
{9041, 20},
{9041, 20},
{9041, 20},
{9041, 20},
{9041, 20},
{9041, 20},
{14220, 20},
{14220, 20},
{14220, 20},
{14220, 20},
{14220, 20},
{14220, 20},
{14220, 20},
{14220, 20},
{20849, 20},
{20849, 20},
{20849, 20},
{20849, 20},
{20849, 20},
{20849, 20},
{20849, 20},
{20849, 20},
{9273, 20},
{9273, 20},
{9273, 20},
{9273, 20},
{9273, 20},
{9273, 20},
{9273, 20},
{9273, 20},
{14941, 20},
{14941, 20},
{14941, 20},
{14941, 20},
{14941, 20},
{14941, 20},
{14941, 20},
{14941, 20},
{14404, 20},
{14404, 20},
{14404, 20},
{14404, 20},
{14404, 20},
{14404, 20},
{14404, 20},
{14404, 20},
{211, 20},
{211, 20},
{211, 20},
{211, 20},
{211, 20},
{211, 20},
{211, 20},
{211, 20},
{1109, 20},
{1109, 20},
{1109, 20},
{1109, 20},
{1109, 20},
{1109, 20},
{1109, 20},
{1109, 20},
{3125, 20},
{3125, 20},
{3125, 20},
{3125, 20},
{3125, 20},
{3125, 20},
{3125, 20},
{3125, 20},
{6149, 20},
{6149, 20},
{6149, 20},
{6149, 20},
{6149, 20},
{6149, 20},
{6149, 20},
{6149, 20},
{1840, 20},
{1840, 20},
{1840, 20},
{1840, 20},
{1840, 20},
{1840, 20},
{1840, 20},
{1840, 20},
{3289, 20},
{3289, 20},
{3289, 20},
{3289, 20},
{3289, 20},
{3289, 20},
{3289, 20},
{3289, 20},
{7019, 20},
{7019, 20},
{7019, 20},
{7019, 20},
{7019, 20},
{7019, 20},
{7019, 20},
{7019, 20},
{17104, 20},
{17104, 20},
{17104, 20},
{17104, 20},
{17104, 20},
{17104, 20},
{17104, 20},
{17104, 20},
{9189, 20},
{9189, 20},
{9189, 20},
{9189, 20},
{9189, 20},
{9189, 20},
{9189, 20},
{9189, 20},
{7253, 20},
{7253, 20},
{7253, 20},
{7253, 20},
{7253, 20},
{7253, 20},
{7253, 20},
{7253, 20},
{9742, 20},
{9742, 20},
{9742, 20},
{9742, 20},
{9742, 20},
{9742, 20},
{9742, 20},
{9742, 20},
{22346, 20},
{22346, 20},
{22346, 20},
{22346, 20},
{22346, 20},
{22346, 20},
{22346, 20},
{22346, 20},
{26291, 20},
{26291, 20},
{26291, 20},
{26291, 20},
{26291, 20},
{26291, 20},
{26291, 20},
{26291, 20},
{29324, 20},
{29324, 20},
{29324, 20},
{29324, 20},
{29324, 20},
{29324, 20},
{29324, 20},
{29324, 20},
{19691, 20},
{19691, 20},
{19691, 20},
{19691, 20},
{19691, 20},
{19691, 20},
{19691, 20},
{19691, 20},
{21933, 20},
{21933, 20},
{21933, 20},
{21933, 20},
{21933, 20},
{21933, 20},
{21933, 20},
{21933, 20},
{361, 20},
{361, 20},
{361, 20},
{361, 20},
{361, 20},
{361, 20},
{361, 20},
{361, 20},
{1081, 20},
{1081, 20},
{1081, 20},
{1081, 20},
{1081, 20},
{1081, 20},
{1081, 20},
{1081, 20},
{2052, 20},
{2052, 20},
{2052, 20},
{2052, 20},
{2052, 20},
{2052, 20},
{2052, 20},
{2052, 20},
{2251, 20},
{2251, 20},
{2251, 20},
{2251, 20},
{2251, 20},
{2251, 20},
{2251, 20},
{2251, 20},
{1999, 20},
{1999, 20},
{1999, 20},
{1999, 20},
{1999, 20},
{1999, 20},
{1999, 20},
{1999, 20},
{2190, 20},
{2190, 20},
{2190, 20},
{2190, 20},
{2190, 20},
{2190, 20},
{2190, 20},
{2190, 20},
{4441, 20},
{4441, 20},
{4441, 20},
{4441, 20},
{4441, 20},
{4441, 20},
{4441, 20},
{4441, 20},
{9307, 20},
{9307, 20},
{9307, 20},
{9307, 20},
{9307, 20},
{9307, 20},
{9307, 20},
{9307, 20},
{3604, 20},
{3604, 20},
{3604, 20},
{3604, 20},
{3604, 20},
{3604, 20},
{3604, 20},
{3604, 20},
{2664, 20},
{2664, 20},
{2664, 20},
{2664, 20},
{2664, 20},
{2664, 20},
{2664, 20},
{2664, 20},
{5088, 20},
{5088, 20},
{5088, 20},
{5088, 20},
{5088, 20},
{5088, 20},
{5088, 20},
{5088, 20},
{13037, 20},
{13037, 20},
{13037, 20},
{13037, 20},
{13037, 20},
{13037, 20},
{13037, 20},
{13037, 20},
{15870, 20},
{15870, 20},
{15870, 20},
{15870, 20},
{15870, 20},
{15870, 20},
{15870, 20},
{15870, 20},
{13131, 20},
{13131, 20},
{13131, 20},
{13131, 20},
{13131, 20},
{13131, 20},
{13131, 20},
{13131, 20},
{10297, 20},
{10297, 20},
{10297, 20},
{10297, 20},
{10297, 20},
{10297, 20},
{10297, 20},
{10297, 20},
{16167, 20},
{16167, 20},
{16167, 20},
{16167, 20},
{16167, 20},
{16167, 20},
{16167, 20},
{16167, 20},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{164, 20},
{655, 0},
{3268, 20},
{655, 0},
{10940, 20},
{655, 0},
{580, 20},
{655, 0},
{3941, 20},
{655, 0},
{10552, 20},
{655, 0},
{1248, 20},
{655, 0},
{8026, 20},
{655, 0},
{12156, 20},
{655, 0},
{3203, 20},
{655, 0},
{19692, 20},
{655, 0},
{21467, 20},
{655, 0},
{14, 20},
{50, 20},
{73, 20},
{96, 20},
{1478, 20},
{2259, 20},
{114, 20},
{175, 14},
{273, 7},
{304, 5},
{13306, 17},
{17084, 20},
{214, 20},
{626, 20},
{2640, 20},
{12995, 20},
{17916, 20},
{31875, 20},
{710, 20},
{1021, 20},
{3886, 20},
{14858, 20},
{22749, 20},
{37709, 20},
{6554, 20},
{10170, 20},
{22811, 20},
{40503, 20},
{45646, 20},
{51336, 20},
{26, 20},
{109, 20},
{498, 20},
{1592, 20},
{1514, 20},
{27222, 20},
{606, 20},
{499, 20},
{2045, 20},
{3092, 19},
{12009, 20},
{38453, 20},
{122, 20},
{374, 20},
{1698, 20},
{3829, 20},
{4941, 20},
{34167, 20},
{674, 20},
{981, 20},
{3828, 20},
{12829, 20},
{14048, 20},
{42516, 20},
{4818, 20},
{6598, 20},
{12242, 20},
{28565, 20},
{24528, 20},
{45984, 20},
{94, 20},
{980, 20},
{555, 20},
{2053, 20},
{2077, 20},
{10506, 20},
{3252, 20},
{1540, 20},
{7348, 20},
{7393, 20},
{10392, 20},
{30889, 20},
{357, 20},
{460, 20},
{2480, 20},
{5181, 20},
{8189, 20},
{26286, 20},
{172, 20},
{245, 20},
{2056, 20},
{7201, 20},
{8902, 20},
{24317, 20},
{1376, 20},
{2646, 20},
{5837, 20},
{15444, 20},
{18302, 20},
{37190, 20},
{277, 20},
{571, 20},
{1677, 20},
{2257, 20},
{6468, 20},
{8873, 20},
{4167, 20},
{4979, 20},
{12503, 20},
{16306, 20},
{12141, 20},
{30633, 20},
{1528, 20},
{1414, 20},
{4094, 20},
{5898, 20},
{11669, 20},
{24543, 20},
{314, 20},
{492, 20},
{1571, 20},
{3039, 20},
{9030, 20},
{20287, 20},
{1156, 20},
{1045, 20},
{5416, 20},
{6130, 20},
{22426, 20},
{20189, 20},
{759, 20},
{645, 20},
{6462, 20},
{5820, 20},
{21686, 20},
{22061, 20},
{6935, 20},
{7416, 20},
{9863, 20},
{16033, 20},
{14554, 20},
{34360, 20},
{985, 20},
{2621, 20},
{2836, 20},
{9475, 20},
{5032, 20},
{29521, 20},
{226, 20},
{959, 20},
{1309, 20},
{4203, 20},
{5386, 20},
{26658, 20},
{792, 20},
{1053, 20},
{2484, 20},
{2467, 20},
{10243, 20},
{17927, 20},
{141, 20},
{341, 20},
{307, 20},
{1698, 20},
{11118, 20},
{23451, 20},
{128, 20},
{602, 20},
{181, 16},
{3382, 20},
{4763, 7},
{24722, 20},
{149, 20},
{467, 20},
{53, 20},
{2424, 20},
{159, 20},
{24674, 20},
{240, 20},
{1244, 20},
{461, 20},
{1988, 20},
{6871, 20},
{18055, 20},
{655, 20},
{420, 20},
{6030, 20},
{1895, 20},
{350, 4},
{21309, 15},
{4, 20},
{183, 20},
{52, 20},
{1052, 20},
{69, 20},
{2757, 20},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{655, 0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0},
{6000,0}}};
}
