// Made by tests/bench/train_strokes.sh; do not edit.
// clang-format off
#include "codec/stroke_warm_start.h"

namespace unstep::codec::stroke_warm {
namespace {

constexpr Lesson kLessons[] = {
    {84, 124,
    "WW2P`>^V_cETgeX>=o9gbdk4dE@aWSRRBDHQIPIB781O<:V?TD@_76_;U?6D[Ep?9QZJ]j9T"
    "J7akf=F>5i37:8^JJ?BE448A4lL`i2d2?1[GH@`1Xc:5jViY<PoTMiAH^mm4O]Q^:iE^4m1j"
    "@d_S8@iIl[@L`H;9=I:gP:9hL=1P[?@JaR9LpUc8A1k0ppS7=ah1jEIk=PE6nS1hgA[lXAOW"
    "YUT_:]=fOb_Ncj3IW0PCTOMYTjjQgD?OSfhk?4Tg84Sn<Fo75Qd:ffGjNfMFQ?Wdb16Dnf@m"
    "RXR8W?7FOc``C^^JLNbBj_A_J5bKYR[f7>1pk7FM]kR_iEeh8R?h_WW`=hLTb5R2>gIVFKJY"
    ";<MgZOdL@kXUbXT`f=^b96;nIaLCSe0YN:1mQ30880>n>=U=bV`K6[XQnC<aE4@eAMXFG8]R"
    "MY=U"
    },
    {99, 138,
    "M[5^bhKN5>KcIV>HckHEp1Tmb5[>GOHlP]SYD=]d[a<J6HKBW^hF@gV0=[XU;9;^C`0WKWBY"
    "2Mo0Db`;?gE@U79Y[UZ=:nQ97Ie8L;I[Rlp:<4mo7@Y[PbWdOOMAjB;[DpW3^ZT9l_FXRGVc"
    "WkXoiQOVXe4kl4M7NN5;T^Vp<8VeZ3mZ@X<SP9pcV`jJZca^Zlbn29edU6BLMp]43lf@0p@["
    ";[I>L<;R1o1@P?a6G7LaHi9AWY5of@AGimWYY2n8f=cmV08f0S6bpl=dW2@2VG7LidTCb>h?"
    "i6T4OG3nD@i<=0YWlTYILKV^<m3ZiRj2b:EY"
    },
    {34, 114,
    "PU12l3QN;`@Yoi[d]i5;Mb6I?YVnY:17EkL3:_5P=@MbJXlT[oGmADMd6WhfT]F:3^Z][VPd"
    "3F]O9Zm2020PaG1_?1l01o;ncfkf3X>SpcJN;n841Co64aE`]np5ecoNl4fZVGNJWkG:XbjJ"
    "?=bYp]C9F`i<LmY^`5Y:jZRnPM7?3BFAmPnTQ:kb18mQ`Kd"
    },
    {51, 109,
    "?V@KSoY37<ITlK;@MBn<pgB8dnUUa@1S1Sd0A8<11ip]GPUNNo:5VEh^S8UfCN0:8_A3?fk5"
    "B]Vh`;PhLCJ[RkQM1NpBlWQZJ<d?i_FaBnPc^gU^n>SMG=KaNfjCWiFm0_R;iYI7iGA;g^=8"
    "c^1gc[bdC<DFAW@7I03:Zoga9Yjm2Dg`=HXZbXJ^@N3p`XV]Z?;OenQ;iUOA1J6I^6OQ;4_g"
    "KEJSS99A[U>X@YK<0g[>VcfcflnekI:Y:mHneh^2FQXPI=LoNe@@XTn<V@gBf;mP;^^Hoi:V"
    "g_P"
    },
    {55, 92,
    "@mW]P=_NlEh>d6BFpK:WCmPY^ZZH^jaH1F92Z<7X4B;OlAPPMM^^N8P9UkTmkQYp1[L`7njJ"
    "GJe15_E8WXg9YSSXLeDm^_3Q@D9ICCfpR<S0`VZ=HTTJ>Al?VZT=D2^<]WQBd@QVQ1dicLc]"
    "J=P4[i0nmf4EfEE@Hh@Y@QcGTE?kQ5oQ1DN`[7Onan@lA``4NVJlhFCEag2ko3gBY5k3VdDU"
    "a?efUcF=5N4MQ@"
    },
    {152, 288,
    "0U;;6Q6=Ui^3^FOi>`hV`6b<@51SQm`DgJJReW7U^JKTAn5?5Jo0RVnLSceMVF;`K`2^T38;"
    "N9IP1X>o`WB=m:184E_`?6XaYc<IDaimgBfB3A9[nj>h`@MEn6ok[af1laJNYdPZ4pVI>Ala"
    "><`1G<?^S9[@0<PMB]eSoS[01Z<RBT94348D9^Mek_ID;ef=CfHaT1;d=De0F?gdneZ_c><_"
    "VYHhDDUKX:7L>GF23=1XEipUDip4NMXfN1<[Kb4QcAfPadk321]7l3hKAo4gK]>VhZ`0hNpW"
    "7ifpQh>ckbgK>4o[@jp9Yp9N>7Y25Q_9dma6n[3nY_oJiaQg[VVYZWUX4bQ8LZj03dnAcE>j"
    "NlN_TNEhEb:n1Dm@49a>NgfTS]GHBh57MRBX?gd>jc4O`pa1f37m8eX2i^[@OoM@?La]N5I?"
    "Q;l]aGdI9k3B9FSOTI2fAjP^`DQ?4Ip_M[;FIEFckiB5nm@kfe`?B1kUjo=c<78LT:P0iYWh"
    ":e[29FT"
    },
    {24, 54,
    ":V:b[lJ[lhdlf9ZaQ95MP3pX`CAQ?14kA9o<aRnYMpG[P?;k9JZbMknkeDDBoF@W^mlJ]N1a"
    "5O6HP`UAU0DGYQMkcXkGO7dP[D2G@b^K]NhmU=1HETAPhU]9gMUac@5cEm<M7LUX4cE3W_F;"
    "T:8fUJlcoGG3gbl4ebPV=3D5@lVQL?emc>gB3l3TpD^K"
    },
    {36, 76,
    "DbDI>7If<jIF1PkU4;V_SFS7ZQ;V=`C;B^<LhEcA]bB65LTm>]ne]:S60>P9RHI^EgGFb8=A"
    "C2mI`e:2:;eMIkli4eMZ8b1`I49@[XjUmL0VmKZ325PJG<i8<5I2FbQU645ZXM?F=YNGZNR_"
    "nEHZVZN850VgOO_hPNVM@@YR<UoOo>10jeK82ll@7EIdTMBeX[Hb1m=aF0Lk3MMPSiAZl4Cm"
    "kSO77^L"
    },
    {76, 122,
    "0CKebij@_;`E=ND[M3Ni5V_>Ak0`XV0X^CBG>R7?1:M<GPTdIo_]:@LioC]Q9D>EDD^;T7P["
    "?`3EnWMDo?E;IHUP<<GpJp9eYiCB[Y]U@eB49>aXU1i_I<F;?Me`IJW>;KV7>Z6Z2@VlKDUK"
    "S`ABd@G[jQ^Nj11[UpZUkDlTX0hKH6]@0^Wk^o:aaJgM8EUU`o<RPnW8jFfQ3Mbp^hl"
    },
    {42, 66,
    "0a@0<V8LI21HZ2<CCjO684=Q[JMDB[E1>NWg9=<b3554V=`WJcnd[=We1T2lCjWS<ZWEkmBS"
    "f^?^<7ZNWU2oHRlp;2YTUoTZmIHC?;N1h1g0_bipgnU^jhMkS9B0<V60FVNo"
    },
    {58, 94,
    "IUApD;VjmSeY31Q9=SAle2;7aQ68ZZJUigMWm^3<nMl;kR5KLEKELFgOlp68`GVV2>fPLE1K"
    "_`6p82NALLno=PpcORY09mN45@ILXoL@[WO[2J=GZ`3`mSlKjjpP@Lg_KdSc2VPMBCULj3[G"
    ";7OjnZBi2FA<QBQ=_`lWOm0>7[p];m<dEPBR1=JD=8>8HBXh<aFfQU;CRSOFaV2VS^ENMQ?k"
    "OhX_a0eTJE;VFHFSQ_3aU?A2K`"
    },
    {68, 120,
    "I^f:RU>fM=kKhQ<9hNj8k]R4P;iNgS4AXC3GHM?KnHkoeoC=p8nF4GEMJ?^gE6T<Bdml[DKO"
    "X[V=Uni;BZNpF`e>QIXN`io8a340U5iYPGl40k1f]CiMiAjdR@6`6J=Ig5<Rn[LUR<7laCmW"
    "L0bYfPLGkK^V^K5284bN@KV3PA:@JaLVBm>m3Z=L=2A8`L3L^kkT?GQeSoW?TaWM=oUNVGjE"
    "KnE^6[7nnCoWmAP1F=oP6fD7<ZWLLbCATLUaZ2URVL:IipL"
    },
    {32, 51,
    "Bc65HXk_5I0OOb:cn<`R1IUPSYNbo;9;GKX773XlS@kN:IP_A?:dNKE<[MO91:997BBA:FbM"
    "IMeVU5XT]bJh89dlf[LX9`"
    },
    {78, 128,
    "C:FH_6_3bK_Q7^hJF>4ZPj^kV5[_d=Upo4]>ljHYRDD8mNGp5>H[R<6m8nSDkCM]MSC_<Ml5"
    "fZJ^J=8k:1W08]^?VbWSVmBelYnk=_H5oHmTIGJbp14CgCQ5AJ9D>LfXcNTJYZ8ba@BRHN4I"
    "`8A:^p7W`MmT>GPaip@S^_8>G6NQ]831F[VaEiENcZDgWbP<nUlNWEj6=2;LUQ6pbV_g2@1G"
    "`@c?c=cn6DjckhXk8D919Koo[SIP6Rl=@SU:ZN@^[`X`Yi<0=l>Mo`]Yd2mHhnoKk_]4?`"
    },
    {54, 100,
    "AT2Wfdl7hKW=DX2LZHe=4NM4S7I0iTX7Ek<2^fLm19_kC5NeWOQ5`klb5dG9Fjj:VlCZ@R5P"
    "n[064ila50plHp6^FFi?GWX0X9coGeC^O4ZD:UB^UHV_@joOKHP^XgnO@oF>dkEJ6]O31?^H"
    "do<FVJ9p]1lhe0@;ZM4Gi0CoL]=7f@218al;AG3^DK^1gMfH=VVI`SZm4Gndmam^oafBD9I7"
    "=YbZE>W5J>e0]hU2KmdOaA:ehkRc8?X1`Wh"
    },
    {45, 85,
    "FF3dP[ALPn=pBnK^eeRW;8AGi8D9;GEdX_bY=_e6NZVVN8`<a6agLL;?K6HAcDmmoHdQbiJm"
    "Yn:AXb7iBX2R9l7<]=35_jh0dD<DEpnXoPP]hpSZB?>1Rp9VEW8gIJ8i6k9QBlTSpZUJU>le"
    "Zo:A3`gohmnk^FUQGMf4ap`ENFMD4K_6^<W281d_0L6If6R2c1ZV2`"
    },
    {52, 104,
    "GVYS@p8<6D;E]QF>hRooQj5i81hH2d1H6@6RD7X4fcMjTaM?SaQ]hMJ5hG5ZoYD6Zb11kJ:h"
    "3O>cRBHj6@DfD?U`^JTXpE^RYCVOhNV[;Cik5Ek7eM<@3CLF6JNDWQ_i^TEfhMfRme`iae@g"
    "SIHhjDQRC:d74Pn?L`Q@G26:a^4_Hi_k58[@VjH3Hj3A:<A@HEkOgoi?51Xg<CY2kbJM"
    },
    {62, 131,
    "0VdL@LO;V_RNmXSc3VQE>D]3;moJVQ=cW`?Be<:Le=;LclVOTRPUlF0h:LZhocRm0BHjUG[1"
    "5a949ag:Njk=OGFT7bbjSG:2k3K7[nYj7kkJGX>XbRbBfjoK?Kfl`8Y4`f26W_jfUagg^FQT"
    "mNa5Ij4@4h=OiXMTdf@aQ@IKnI_S9Ufgc@"
    },
    {23, 69,
    "W6if<0^18:0<f4`@SNoE0IU19RSWnPjU2I2im<0hHPGd2f?cGoL_Z@93]ZW76?[?<FjE<Pap"
    "dLFlPeopP3F?N5?6m8XBP3`1ZB3P1o;k8CLFI8]EH`^j=^`^70W=7jQ2VAb@MI4:NAb^p77d"
    "HFPgZMiU8]Oo"
    },
    {50, 121,
    "0<HiK88ZH0FV@?bCZ2Mj3IY9DPJ4EbfTKknLKBCNP[[h0Yf>_AD@eQ8oKhfp8D`^_g:A;4NM"
    "R6Z?>MA9OPF?2GCH_:a78h9kkHi=CH96<dc:RlppJ1[EB7hJkog2iPaj<LnS@1TlbU0ic[`G"
    "gB8FQM7X^DJ`WOd<bL0dcGN@:ja`NJ8eV;?9[]4Z;C[PkglVlQn<6ZpjdFphgQW3P=HMppR4"
    "30`oPb?fbEZ5U;Io7F5N6KT@7BdYlk3Cd=okehRh`dM_g4<VQ6Tp@[OWU65H"
    },
    {43, 103,
    "pXl6^MG6_0K<dXoU@6g7L>U1_I>=o6NG4F4]7E9c]k_NWmQDV]VUg3jM`jY]3pi<CLp5lI=^"
    "c[b@iLXnBY<pf[NUQj[WTp:2I[ER57anpgc5QVLoXjo:m;;=@J[b=F<?8iBdLAfj9i<DH<T?"
    "Z6@e<3ojOB9:Wj2kIFAiiW:9>3[3HPh@OXW5@mpBXD9ZfJ>_j0=G:M5P6^9J3ocV2YfSkUeJ"
    "gOc4OW^a9RLX7nXj4bc88X>O5J;AC9KhoAdf"
    },
    {47, 95,
    "^C@hpRX?""?iFg[4jKFP5LIZWLZ5eBE]=X;l`ZEnOePQl[^4]GUddNQ_PP7l<4Cb:3X[07[:dp"
    "djm2JG@O6^MG?@lch<YKnTI?QWA@1EZ?0ZBY16AUWY8WI[^8l4T4ZXYBkLMANWhHoG?1S2;6"
    "TlG8VY071Ef>T3Mk43S`hgP68FAOm6;Xg670_KUU5E:2FT5Nn?MF;QM5gonK]M1m=0"
    },
    {114, 218,
    "0OXWQQ]naB8jpY89LjphIlc4eFm0KRQG7CR:_49a258`i>ddOm?>P2Ipc@C<1Tc?=VG=MlAm"
    "a`b6@K8HI37V9_ZjbH>DY`=Y^Qe1F[BSd5g2R>c3_KPoV[NSm`7O5i9faOI>JWBKLG6eV@Cj"
    "oZWKkE6<ZeHJZh1H1[V`Vkf0?""?S=Q:hSNHa8ZJWd75Do[S:fj=A_<QkUnJ6niS7ibKlB4PPc"
    "DcpKaHgd5]cAdT8Qi;5QE9H5E>ohlX5NSlJbLOk@TbAOE<cCZJWZ`h0akfEFkR2I<^ATM9bX"
    "^XbUQ97[Jg6=mW]GjOK0YROFEhnAc`afaN9HRNKZ[UR4XM7pe57[V6[FIXb>40kG;ibeh@HB"
    "3lLD;<PFEED6jZV02Mah^gRIBicP:ah"
    },
    {91, 186,
    "POQDNc]:pYVbi9U=hnoUDEa_7>FFU:kN<9SMiZ:e^DlbTKH?gL`p0<CS:mG[X3hVMi`Dk^b^"
    "_0[[:d]<KdfW69e^Ykf]kcGYP<7?<X[CNUh1hA?a5_VPG`<?@OcETTpigl[W5_Y;Gn>QfVgX"
    "pm;2BiVI1@PFfFaG_@[IRgKKjOE6TOb<b;>p[U9@WTAedOf_<YmHGke7;P;RSe2_5DB=CjZg"
    "U9dWc6nfHPo7APB83ioD1R<CjlcYY4ETU2Tl"
    },
    {116, 239,
    "PecVWlo>VMHVQ42L6]KJEK6Xba3V]QTF<6=CW36j3KKX^B_?^@375EQ9RFdAi0lBa9Y5Ne00"
    "5`i@;G6Vbd[k6aSO^n93f;eO0MBdHPN5A<WN38lNiae6hoD?p;d;12g4KaXhIlC<ZoA[H5df"
    "@3o]1nM`T@o7cVM=<R81Oe;ZnAJ_NBbJ_[mRXLV]aQ=J6fb@6IUTU88epJkk>gS3<ggVp`k4"
    "bKRkDke>^GKpZ:4aA11d8dfe1Ue8Hgm3@Vao5<6oM?@hJPIf2DBPhKhG4T_BbOc<3F7mQR;C"
    },
    {17, 27,
    "QTKa;V8cZo27bZCacI]CMm>TVnDLhE<n`PT;La1[iQV;2KZ^JpjaJ=NHN1Lb"
    },
    {84, 184,
    "R?[JLfWghmWb4lQWQCB=iZ=RNSPf[]GV;R^Gg3B?^gFd`7aN[cL7SN45lZp7@^8AJlK;P>:]"
    "ofj>NVg1Nk;RTW>nF<F:KLGV_6ie9TI6L`=6iWo<PL?[VfOjlAp5`6_S21>LO1A:?HRO_8RL"
    "ZeXF:ZLZGfkgnBQ>kC2LPHlP=LVgXfU9[bWccdPI3g7AbL:>QD7`5QpS8fNA>P"
    },
    {87, 201,
    "8aAG]_B<8iK@@7X0bO;BQ:O6DQ]0;D9c3TmF>JSUHCE5EiW`2fgFIZfaR@4<=WQQG>PL2@NA"
    "K=b3f3ZBij8L?C`aGB3pH?Jm;`<S=_ZlB;K[WXDkljeEcUi5Yjk6kKBY@YL]ELj4GKW0HF;;"
    "f[i<XMScdf?B6;Mn?0R[[CXf8Wl9<dhgUGY^><VZ3^ipDKI>SCPDkA5MFNOWUW?NiY;eHR@W"
    "fA5A@GX:bYeo7ZOApAKgbeM=8NAAgK3D?QXhQ<Jnn40A3<gkhK[0<eMYcdLJXdHTTdhV:WB5"
    "]`of9hQm=V^PmSoF36d>gYEj>;dHeDkfj;inR7d3kEVUpZAmiK[Qn9Ph::22WeXl_OTZ4Hg:"
    "IeNQe1@0AmYR<p[>`6o44kE]LfmBeWi`cPG>"
    },
    {67, 167,
    "PEVCp_7VAPk^BjV`_H>;_27:GMCB]]I6QceiAJHDlj>SPf?9o7[d[pLNZcj@558pnd9QXOFd"
    "Mg6eF07B?YJABcVabC];ffEY<DWF5XpED2QfRW>NXR5h?T4[c5n5^mb[]8Mh`03O0piPoYGn"
    "N>ZEJ09gWfmhaanVNKZA?K:D0FmNP3nNmiZdRnfO5IhPmOmL]gWhTh<hhf^l=dVY?DXemH:G"
    "h[l"
    },
    {71, 130,
    "<M<TR><cVYALj]`7^dFKkI`kfFYdFp8njI34b5O1D:>eim0>91oMSEReYTUR9_h[Pd@<nk72"
    "fkigS14_XNPDCg3]RYFc6kJneDRnkn2jXaJn[J7g[O^HcdB[g4Un4NKOBC14kd?5;NdgV0hP"
    "gjdBJVl6?5R]KELLb<T"
    },
    {79, 155,
    "PG0Hp?U9lFRh>MR35gf0H?m?md7T@::QI:bTK?H:NIMDO[Si44TPH=5pdoHJLRfl_^Mih?Ni"
    "8EYiUmpGAf^3NFlXhY=^UTaN^NW<0Cm84A>_d_p>>hLoLcjX4MfKmlEJCYmURdP0M`h:l6mQ"
    "pH4CjiL<6JFWo2Da2`3cK>le>hjLm5H"
    },
    {100, 216,
    "o1Z6icUl[H0:ibF`lEQcAIl>;llV>=Q`6M905oaZPbU4n[WQ97l2EI2^FFS5JE1`hl0CQZVL"
    "43[a5Q=6KROfUjmBMjDT5HZIP3^_p2Cd>[2;WmLB91=hOFCQ2kI1ILJZ5XDW<D4TDDVi>Ck>"
    "Ka3pg@IRZFaFA:nbT6XWDVgF0b3Xck7TB`64I4LHmMEe7fi>IgUA^afCP2XknWnlPj6i=@1?"
    "g?Ih`Ihmmj9HL52faaZ24Z;l^Pg]OM=HZ[EcB>_?]?_EDM`V1K5^eK0cGhPV9lpp>W]<hX>M"
    ":EKYC^:`9T]EcRiES[LRfMYPElE[h3N8NoAc6^9Xb15oF0"
    },
    {47, 105,
    "W<pC7pdX7_6ScI9L3McW^9]Lg=UB`ad`g;n2m6T3Bd0W7`D[h>J?]Y8;7_Tce1jdeQlhpdHb"
    "[eRc661KViO3ES@e9a7F6P:S7b:TSJm9L^ieOSD8`emefXHhT^6Gg5lj@R6_peI]CbLba=iE"
    "LDMldUTcliW:CF]Jle][=@XGd2C7^hLMRRHbp><N"
    },
    {36, 83,
    "Y8CFa@m[kOS@n5`bV=EmAgcnSXb:jAPb5SX0?XMFQI[Ce2e_6o5Q`UbX:=Mb8;lfO0Q=B4ID"
    "XB[jC;Za18bHWMX=k3CfnFh@Fiaj9KP;cZc@:Pp6g<^p]d7fGX_fk_811aG34Se=8iaKXoLf"
    },
    {82, 200,
    "17=MIDZ0:GFGI=<odnh_bH9Sl[M`b9X5WiC8^=F:Tg<RC?GQ;:9JiHT1`PUMRlU1Y9oL__O^"
    "GSmj43PUoDaQIRR?Ig3F9fpGA3hkji<Q6`G0mf;j@DIa04bG7j<D37V7K[odY4mVXO1P]J?I"
    "dC>A>:eUjNG4?""?S1g>2Ob]:CSac;<dSP_:D<PpWF]^XdL`OVVnbN6TdGN1pYU>;p;FaRCcpJ"
    "EUgX>BEXh4R4k;NE_V;pYWA6d^KQJa@TS5F`:R4gK?<IUnXpekk`:pS41]G?L2DZB9KNMOj6"
    "mA0]>jJg24R1?Z3PEcQ1VNeS^Q6Pe=g[piFQ"
    },
    {88, 174,
    "V]DNP3Wjij3V[OUE71E0XK^4GoO<MjkYU7Lj4HN[0;729m0gpdIK4=7_17h>@gg2`A3]BnOX"
    "8_Vo0f]_9OME4_?FaFf;TY786U[HG>36UWBhUR]XZdFLnIJDo7PNcZDmVNL2oMG<?c:P4nN?"
    "Okb1Q6RKjF=hF_?ECe4FN6ZGDmVYEMd?K43m6b^[PWN>RlG?NfdG<2S?a6OHeo0c8Q>dXNUE"
    "RW6Uj0OJYBAOgT?a:N^E1Z8Q2<[AfEb<nS6Eh9HBckcibJ94Q@N1@:MYajWjTlYI0<1ciT5c"
    "e2PXcMX<O;7WB:0"
    },
    {38, 64,
    ";l?]?1jC<O@E3CK0QA=C@kW@I=iBFD`=hWQJ80a01j7276M^41LB;1_cLfob2H<=V=NLFjm;"
    "M8_:n<FKR]NLbE>mL:LEkR[DmHnD0PU;]Q5lNS[45LZjpb5aDd<5:AOLP?jMVnVNUAlbe=eJ"
    "@Yb0[JY7T_42GPR^n:4;e2d5l7p@W:_7I31ke`o3>i^9Q8iLDRIF:1Mm:8bDmPgdoO>WKid7"
    "2Np?9Y5Tc4L"
    },
    {129, 221,
    "VKTdG7fU5jlIf>OI2I0eOIA[?[N>kM]a=LMA>7FfQ<D>Sf[XhGQL6S>KGBmF`F1;]>HBhAHU"
    "1eSR4]BCM]nX8F@^9]_`d6Z9h?""?KoiLkI@1>:P>eklY4m@IPa9ca3F?AkKYjlY=SQkVJaZK^"
    "^[iS^A`ZDSRLVgf@W0B::[P_abO`@I<Y>kmbmi;VW?X=`^B7b:E>p8=BBdY=[E5OIacJ7[G0"
    "0dD<3298DEiVUgYfXSY`EiS8gMLJM@D;0S>JngbTW]EcScYpKml<:^ENpn^Qp=Y7nl^jBM0B"
    "_Zh0hNkPDc7fU8aXSc;:k3Aj19cMT@e1NZOC>G^7oh=c;d_JJO3g5EWO_9C^:eCH8N]^nUTO"
    "@@<d6FJcd:TG_C=Pf3NVccJ699VYTc50k7FmT:ZlV;6D0hJ?16n8YUHBA3hc5o[MllaKWc<Z"
    "1>5UU625CE;^bp7dDGGB?6C1bX[G<?dj<dN9L>C<jLKa7hbG44M3Cc>YUdL?ekp:D5UNf]W8"
    "9nhkNCKodoVNN4IZ=NbcjjFEEjpGa[h76HV>2MKZWWKkg:?n=YH]Z2kICIW^382VnIn]`iji"
    "<TL3YTd7_KZQ7CUUJEM2dfT_GC7ch_OnD<]6kf[09okQj1QMA=^iAYHeSBSP7fFHo@<cpjb_"
    "49:M8hGDI?PEFmck0@4@HCO?db9dNMR^XQRT<ZgGj0loQ_DO2gcn7fQRWgVWSW4_?C4FBQ]F"
    "NOQ0BYe9eEUa>4:TIHjIkQU;`0eN]Zn2]BTXQAF_PJE[f0`0^2Tb0^>0TU7:eSeXVOU;D3eU"
    "S;hFK4?QJcZ2"
    },
    {47, 80,
    "07ab=7>[@l=1J]0n80D01R[5=DS]T3]Y0JQ;9oCP8B7_8QnN9_8:7NBK23[XVml9[G9dH2p3"
    "jf4UfG;096il`l?Og0;bM7C;6ni=E^0Z`jU80?AKJiUgm[XaE7P46@Aihg2fGO1lKA;Vi@<p"
    "epmU<4BL7Fnh>VH=JLJOe38DPDU?C^o[]>Uk?GN?:mB]=;<BXYl?7CFla9=Em[V]6l9[QiQc"
    "QG;pLle:QGD<m[0BNB<T5A_3]B;2Ce4F7mDK9bG[mE8"
    },
    {35, 70,
    "_Ac^CR1?Pf7c@LFG5NfDgUAXGPjemW7]C=V`L^0Z^WD?nV9`X5LiP2Y>k@0<O_dHTCGPXbK>"
    "jG6o>B1h4dBNpDhgSSoal8[PC[:JK]B`eZV9HKYYOCMnQ`oe9Ac9>IgUYp0][]B97?;n:mWJ"
    "k;BYTCPG:MVaa71=0dZEWDTB49[9c6@=<]jGO?""?b3SlLU?jcXXBiQDoLmMQOH9Ld;6d1Onf>"
    "oPT>hZZg"
    },
    {45, 92,
    ":e<0pejo4CYQUBM>fnVnQ[j;UXTG5KADWgacYcKG0c5Ye[JX_8gRE3fKjap[7^;>3JLpc=3e"
    "X@`cM6n?HG2m77cE>ZSkR=8eZUFO8=D1F=;5h2F1=CP?]jWNV>>Nc7abWBCok2DLASkKdSjN"
    "Sion;HH:@Y6bGgOOWp?gc9o^g9`V2Hd`3Y?bHGfmUG_NHbo;BoU;PE4a>5Ed?8c^nSF<Xf5X"
    "JT:fT]kLOYDYY5OhZk>X6G_R2@mE:CmLaeE`n1Z`:POL_WLhRolCblRnIQ9p9jGXTT<"
    },
    {94, 221,
    "Q;4h3@fIWmY=cl[4mJbYWCKOLO;ZRI<URfb^emFN6fe;Ld5TYEd`XeE^?^l;QJ:^>o]7Y]ef"
    "b`6Wi3LpiNR=`aZSdXMpka]>hlHU84R`HZ3e2]^2PlhG97RTR@5klJo3TeJo0hh_SAN@_NaI"
    "8NViBlM3>@dJhRH5ZnW14cE35O6@W2^Gd:E>>^bSIcZYJX2gp?nOVTA>JNU[`5?Y;=[LJ_lb"
    ";^C@i^baRDDSb_d_dh_73L;LQ4b=^PPhg=E[21KN4agMVAJ0i`fZ^BK7eBNjH6@lkCM9lSD0"
    "^=m4gdiTElD`M0glnmbg4cMC]bDX`]SbNXBjH;DCOXjmWjU8QHJYQ]ADNX=p6Sd8h;TWdYjF"
    "[dC4`AJJTMpmkA@fc1=:TjBRm@=>o6gl?7pZ1MXlaW6NOQ7;k@oGLR]F]1Cnm:^UoY7A>[cM"
    "0f;Z=;PGg8NJc[hC=Q^3nilPKcGnjWAk5X5Tl[:T<j2Mg1Cmg^E:<?npE02J54Bi879:CPHm"
    "5k_XgF^VpRRI<hDO;0Cm79O>8W^IE97hm4AYZ]G2n=LHi>niWL2IbK@Dpdi5WO^b0g?N:eme"
    "3cSEejCF1Xi1=kWNg[DQV>a51_JfbRMH<MoJikhb2]=^dW6KSX=KM`;F"
    },
    {11, 20,
    "R]YIcao3kk78ZBGEC=p3p3d;3d8Y1J`chAeZVBEacoX9d>Kc438ghdWD>8BmMbmEnOWlC8<"
    },
    {68, 153,
    "P0akHeCW_=gQgjaC<W`Q<Tg3ALFD9I;HFF8B4n;k6M^dfg@Fna13:nQH1IIR@ZJ3hi6W72dI"
    "o04aKJd>KP[olN>[Wp95R4Ffc9jhEeA_XlmUf=GoQ::b:aEjj6AajnBhS?iRahP]b?K8PiK1"
    "5@e8_32fXfc2?eVS`@10YQ99:mNkSF7X1pQRCHa_Ml=E4?""?Xba1@HK0QoT4D9QlpKZfXQGDi"
    "c<f9R75X6NM31mn?dRmUF=;W96iCVKFPf5<@VC2cW[<[Q63Go226``?MMi23PM=KQmCMD5ZS"
    "Ad1__S6kWbm5S_he>h7N=G[9<aJfX8;_26<JhKVH?E>Md3762`^M;12[B5_TKikmV1Z@5QiN"
    ";h=?D]beZF3QT^8a]oh^<mGl@Z03Xn39"
    },
    {74, 127,
    "T5KR6P9oLV5A0QcoZ>NlMb_WCQS];S5MUKXNgeWFM1L0b:HV9jeFTQ20C;OWn8i_RL1U<dle"
    "Gdf9YPIY9V2HL[h:OJmfbS6FBkXam@80=`p4CWGpDTO]IF2RZ[8gfnY<W<mPFL]C1LMYJKm`"
    "LBd<^=ZXB2JSo9pLkW>==@Ap:G0HTkW88NDRTL8gM_[D>j5=_HdLLTNW9e:OaXoTcbimh20B"
    "1_kodXce0IXUGk68@8g>W`1hlfm<2kS74H1mf4S;B8[C_>hn7nSIZUJ`4CmIkWN=2j:1g=_S"
    "FBOMiB;Yofib3E>pV:0oV@ogT?PHKiLEUGn@;5om0;0YAVVKGCZaTlFp?pO;FNfjOj?:hfQd"
    "mpmRdIR>A3g2`FQ@2E[:R8Mn0@"
    },
    {36, 64,
    "2;@M9YHIOSV3eEl5Q1^Xh6IJ@Z?GYK8V:`9giVXK_AFMf^H4Q8?BFQE5dQJ;=PYSf5cIZOOb"
    "[_iAF^;j^o_7YLQN?_X1RUZEF;EIm>hBnTdekciZQ1^B6_0pC@BBVj>g?nDi]I<^]7hY@V?7"
    "AiK14CN4[WTnL4>aachZM>JnK`dIKG[5PU:S_E6bCLBKcEe5`bfMoRSfem9o5:9?>U@"
    },
    {64, 175,
    "4]22mlTBRf^Z4Q2ETRdSIVR`D6ZA6iH:jFD^c`4nH<h?V:1VRehdOo4AYh[TMeeO0F6I6`35"
    "062GmZTHMdVP;<dEAcM2AEL7dLZYnRE308SGn[;LMRVE1@To@5fdco1G3>nmO2U9^Z4H_]po"
    "?U`ggD9]a_IJd_ijK0<:]]5]>YcE481VL6Iemp`hnc6_f?1KC2Al_N9R?JLm4@;ebWcW5Xil"
    "ALijCOkYkQlW5iM]d@[;jOV]_]W=;PMm7mXKY^e4MWh>HW2Yp7>?:[M^nhUGZeWhPWObN8nY"
    "WpPclI7mpKRL::9Y:V1g7>23?C`cnO8>>PVFL5g9OD_48AnADUR;6pl85nLceT;hSXk6YA5<"
    "JklR`XcA?_OPl_>;iTHZO2`^Jl785em[R1cE5V3_936D8Fm`[54U>0;53hZ@ET@a_eAXPHUP"
    "XC5JNU<HiVp"
    },
    {39, 84,
    "@i?`hQ^`6a1M:2d1V@nYHJZFZ>4PkMUVJ9?d0HhLKc4T_J@=bTY54AGCFlMNSof7V_hA0k5g"
    "`P_oVEOXmNh7MU;MLEeLjFUU1f2ekXhIaQ^E3=4W:cI;@Q4?hm3YP30e[Ye=NO5GI?eHQCcF"
    "m`]^iK`GUiO@Db?I3YHpfTcV3Gm<7dG[pkUb[XQ`e5bkeK1_eDG>PJYFV3IfRK?;]S6ikoY:"
    "Vl4dEmk4adnX^TcmWk4Q?iQhG04T`Y_GoXKEokn[G0"
    },
    {79, 218,
    "2;6nIT9;ZS?8ek^9maEWWDAD;C?j@H9HPdD_ATER1diXXXV00YcodbNN:9Ldnb4>ph2CDa1a"
    "HeI;D38[2Io<;mcMC[X`UCM5W0kl;LVXQF49WjhJ:ol^koH5`Fk1;9eFWZ94g<6?Lp?ZR94D"
    "nFCM?9fB54kGIMg:H]459SHdaK:d7W8?cXFmmUPFh37`g<[:BPnS^3iT0GN[2[7P]ohHDbOL"
    "KKYLi2OJSgF9VeSMnCPRDfj<87kQl;<W]17SCjNJ[S1?1e>@PiJkA:Y[A>K2VF4J;bV>k]0h"
    "BUo5:jb@lmaJLFchIN_pgdWoGT`XZF>>DW?MhHM2D=h2Rd84RMF4V3lTKm1?_][Ii7QX]_Fn"
    "<pgC5p7Ad<4cQ=`8a2dP_TCMAT]nZ;mCA0UQa9GO?VnW=Sn?Y@eFDWAcTaZacSONi<[G?_Wp"
    "mFZ<VXFO9GIalfYG>13d`?X43fD;LoNaL3=i`bN4I[4l`8fpgBgcQLaOY2QhmL=eEW5aLQ@4"
    "KZo_>OfCYZacR]C@hB?FTj2;K1eklN^5Zk^W]BA>U<A:KMc<^2RknE@c"
    },
    {50, 105,
    "KhORYOKLmoE5Rna6A^1Nm;e2BKWV0>N>oDm:;mRglE^ldJS5mWm^7T2:a3f_DpZcE0hmiQD>"
    "]>jP37<3ZkKPQn?n:XeE<Hj@^5U1926<dRln5=FP[X2n;X[H3;`oZ8pf5_Mb4GbR^4OU:H]T"
    "f1A[KUDZDK7gBbhElC;KLeddZf0R5;YjMPjS]`GT1[]Deh;POTHbK`^IbW>ZYIHiNH?];iN7"
    "?X3Z2FN9P^Ke5LZA:3oHji;HQDhp?pf^V;I=j;n38D>>JlU3@;CX[gomE:I]JWd2^4I8=hCU"
    "HjPG?ZkENk1AUnXblVbQ2jIl_0"
    },
    {38, 98,
    "55<AI5?M8E034P[QeRMR<[bB^a5Wf5MgARKGZ]<`K1<CNdESp^VZJXC^Z;RKRWna533mGFKB"
    "`5=DbR>2PG5XidD0=W@j0TL_OLRXQNZAfZLJi><F6>mPl^KNQmMdgeIDZSJbZa:k^G^8`ek["
    "[?NnGO@nW=[=T1N;AUbZjeaQn:2cUI:jFoXFE4c1G3I[5Y:_4>_O2Oi@^CF^2@8YR7o4FQjb"
    "LfkapEiPcF_?Nj;3h:WV64<ad1T@6IOMpf6ON5_bQc4MWl1Mnc]7WLnn42K]9NL6CS<DE8X"
    },
    {38, 85,
    "=eKoE>gLC1ARgeiW5lJJ>jGREnNm5;g85Le<?p4h<GIHV1TGG7EcY<F8LaV>XbEUU88nBoGI"
    "nC5c=MZ<bO_S3hmpY79aoKURU>63T1Af]e_VQdc`gXRbcI?baGKLXlKQEbjNnAG<`=Hn];<f"
    "dE;0i8K7Jial@5l7DApM]6mTU<A35lWQG1UL5QKniMjkSLVGlniLn81WjoC3BpkK6LQ@]:I5"
    "j>TR_FGQUK2gc]WMFd0_SpQG8oE;1R4<U_`U>WfWhW_iHYU=EheY4F6lGD9D]<2O:O`;RK;K"
    },
};

}  // namespace

const Table kTable{kLessons};

}  // namespace unstep::codec::stroke_warm
