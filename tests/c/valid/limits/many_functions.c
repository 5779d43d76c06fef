/* Five hundred functions, each calling the previous one, and as many variables. */
#include <stdio.h>

static int f0(int n) { return n; }
static int v1 = 1;
static int f1(int n) { return f0(n + v1) + 1; }
static int v2 = 2;
static int f2(int n) { return f1(n + v2) + 2; }
static int v3 = 3;
static int f3(int n) { return f2(n + v3) + 0; }
static int v4 = 4;
static int f4(int n) { return f3(n + v4) + 1; }
static int v5 = 5;
static int f5(int n) { return f4(n + v5) + 2; }
static int v6 = 6;
static int f6(int n) { return f5(n + v6) + 0; }
static int v7 = 7;
static int f7(int n) { return f6(n + v7) + 1; }
static int v8 = 8;
static int f8(int n) { return f7(n + v8) + 2; }
static int v9 = 9;
static int f9(int n) { return f8(n + v9) + 0; }
static int v10 = 10;
static int f10(int n) { return f9(n + v10) + 1; }
static int v11 = 11;
static int f11(int n) { return f10(n + v11) + 2; }
static int v12 = 12;
static int f12(int n) { return f11(n + v12) + 0; }
static int v13 = 13;
static int f13(int n) { return f12(n + v13) + 1; }
static int v14 = 14;
static int f14(int n) { return f13(n + v14) + 2; }
static int v15 = 15;
static int f15(int n) { return f14(n + v15) + 0; }
static int v16 = 16;
static int f16(int n) { return f15(n + v16) + 1; }
static int v17 = 17;
static int f17(int n) { return f16(n + v17) + 2; }
static int v18 = 18;
static int f18(int n) { return f17(n + v18) + 0; }
static int v19 = 19;
static int f19(int n) { return f18(n + v19) + 1; }
static int v20 = 20;
static int f20(int n) { return f19(n + v20) + 2; }
static int v21 = 21;
static int f21(int n) { return f20(n + v21) + 0; }
static int v22 = 22;
static int f22(int n) { return f21(n + v22) + 1; }
static int v23 = 23;
static int f23(int n) { return f22(n + v23) + 2; }
static int v24 = 24;
static int f24(int n) { return f23(n + v24) + 0; }
static int v25 = 25;
static int f25(int n) { return f24(n + v25) + 1; }
static int v26 = 26;
static int f26(int n) { return f25(n + v26) + 2; }
static int v27 = 27;
static int f27(int n) { return f26(n + v27) + 0; }
static int v28 = 28;
static int f28(int n) { return f27(n + v28) + 1; }
static int v29 = 29;
static int f29(int n) { return f28(n + v29) + 2; }
static int v30 = 30;
static int f30(int n) { return f29(n + v30) + 0; }
static int v31 = 31;
static int f31(int n) { return f30(n + v31) + 1; }
static int v32 = 32;
static int f32(int n) { return f31(n + v32) + 2; }
static int v33 = 33;
static int f33(int n) { return f32(n + v33) + 0; }
static int v34 = 34;
static int f34(int n) { return f33(n + v34) + 1; }
static int v35 = 35;
static int f35(int n) { return f34(n + v35) + 2; }
static int v36 = 36;
static int f36(int n) { return f35(n + v36) + 0; }
static int v37 = 37;
static int f37(int n) { return f36(n + v37) + 1; }
static int v38 = 38;
static int f38(int n) { return f37(n + v38) + 2; }
static int v39 = 39;
static int f39(int n) { return f38(n + v39) + 0; }
static int v40 = 40;
static int f40(int n) { return f39(n + v40) + 1; }
static int v41 = 41;
static int f41(int n) { return f40(n + v41) + 2; }
static int v42 = 42;
static int f42(int n) { return f41(n + v42) + 0; }
static int v43 = 43;
static int f43(int n) { return f42(n + v43) + 1; }
static int v44 = 44;
static int f44(int n) { return f43(n + v44) + 2; }
static int v45 = 45;
static int f45(int n) { return f44(n + v45) + 0; }
static int v46 = 46;
static int f46(int n) { return f45(n + v46) + 1; }
static int v47 = 47;
static int f47(int n) { return f46(n + v47) + 2; }
static int v48 = 48;
static int f48(int n) { return f47(n + v48) + 0; }
static int v49 = 49;
static int f49(int n) { return f48(n + v49) + 1; }
static int v50 = 50;
static int f50(int n) { return f49(n + v50) + 2; }
static int v51 = 51;
static int f51(int n) { return f50(n + v51) + 0; }
static int v52 = 52;
static int f52(int n) { return f51(n + v52) + 1; }
static int v53 = 53;
static int f53(int n) { return f52(n + v53) + 2; }
static int v54 = 54;
static int f54(int n) { return f53(n + v54) + 0; }
static int v55 = 55;
static int f55(int n) { return f54(n + v55) + 1; }
static int v56 = 56;
static int f56(int n) { return f55(n + v56) + 2; }
static int v57 = 57;
static int f57(int n) { return f56(n + v57) + 0; }
static int v58 = 58;
static int f58(int n) { return f57(n + v58) + 1; }
static int v59 = 59;
static int f59(int n) { return f58(n + v59) + 2; }
static int v60 = 60;
static int f60(int n) { return f59(n + v60) + 0; }
static int v61 = 61;
static int f61(int n) { return f60(n + v61) + 1; }
static int v62 = 62;
static int f62(int n) { return f61(n + v62) + 2; }
static int v63 = 63;
static int f63(int n) { return f62(n + v63) + 0; }
static int v64 = 64;
static int f64(int n) { return f63(n + v64) + 1; }
static int v65 = 65;
static int f65(int n) { return f64(n + v65) + 2; }
static int v66 = 66;
static int f66(int n) { return f65(n + v66) + 0; }
static int v67 = 67;
static int f67(int n) { return f66(n + v67) + 1; }
static int v68 = 68;
static int f68(int n) { return f67(n + v68) + 2; }
static int v69 = 69;
static int f69(int n) { return f68(n + v69) + 0; }
static int v70 = 70;
static int f70(int n) { return f69(n + v70) + 1; }
static int v71 = 71;
static int f71(int n) { return f70(n + v71) + 2; }
static int v72 = 72;
static int f72(int n) { return f71(n + v72) + 0; }
static int v73 = 73;
static int f73(int n) { return f72(n + v73) + 1; }
static int v74 = 74;
static int f74(int n) { return f73(n + v74) + 2; }
static int v75 = 75;
static int f75(int n) { return f74(n + v75) + 0; }
static int v76 = 76;
static int f76(int n) { return f75(n + v76) + 1; }
static int v77 = 77;
static int f77(int n) { return f76(n + v77) + 2; }
static int v78 = 78;
static int f78(int n) { return f77(n + v78) + 0; }
static int v79 = 79;
static int f79(int n) { return f78(n + v79) + 1; }
static int v80 = 80;
static int f80(int n) { return f79(n + v80) + 2; }
static int v81 = 81;
static int f81(int n) { return f80(n + v81) + 0; }
static int v82 = 82;
static int f82(int n) { return f81(n + v82) + 1; }
static int v83 = 83;
static int f83(int n) { return f82(n + v83) + 2; }
static int v84 = 84;
static int f84(int n) { return f83(n + v84) + 0; }
static int v85 = 85;
static int f85(int n) { return f84(n + v85) + 1; }
static int v86 = 86;
static int f86(int n) { return f85(n + v86) + 2; }
static int v87 = 87;
static int f87(int n) { return f86(n + v87) + 0; }
static int v88 = 88;
static int f88(int n) { return f87(n + v88) + 1; }
static int v89 = 89;
static int f89(int n) { return f88(n + v89) + 2; }
static int v90 = 90;
static int f90(int n) { return f89(n + v90) + 0; }
static int v91 = 91;
static int f91(int n) { return f90(n + v91) + 1; }
static int v92 = 92;
static int f92(int n) { return f91(n + v92) + 2; }
static int v93 = 93;
static int f93(int n) { return f92(n + v93) + 0; }
static int v94 = 94;
static int f94(int n) { return f93(n + v94) + 1; }
static int v95 = 95;
static int f95(int n) { return f94(n + v95) + 2; }
static int v96 = 96;
static int f96(int n) { return f95(n + v96) + 0; }
static int v97 = 97;
static int f97(int n) { return f96(n + v97) + 1; }
static int v98 = 98;
static int f98(int n) { return f97(n + v98) + 2; }
static int v99 = 99;
static int f99(int n) { return f98(n + v99) + 0; }
static int v100 = 100;
static int f100(int n) { return f99(n + v100) + 1; }
static int v101 = 101;
static int f101(int n) { return f100(n + v101) + 2; }
static int v102 = 102;
static int f102(int n) { return f101(n + v102) + 0; }
static int v103 = 103;
static int f103(int n) { return f102(n + v103) + 1; }
static int v104 = 104;
static int f104(int n) { return f103(n + v104) + 2; }
static int v105 = 105;
static int f105(int n) { return f104(n + v105) + 0; }
static int v106 = 106;
static int f106(int n) { return f105(n + v106) + 1; }
static int v107 = 107;
static int f107(int n) { return f106(n + v107) + 2; }
static int v108 = 108;
static int f108(int n) { return f107(n + v108) + 0; }
static int v109 = 109;
static int f109(int n) { return f108(n + v109) + 1; }
static int v110 = 110;
static int f110(int n) { return f109(n + v110) + 2; }
static int v111 = 111;
static int f111(int n) { return f110(n + v111) + 0; }
static int v112 = 112;
static int f112(int n) { return f111(n + v112) + 1; }
static int v113 = 113;
static int f113(int n) { return f112(n + v113) + 2; }
static int v114 = 114;
static int f114(int n) { return f113(n + v114) + 0; }
static int v115 = 115;
static int f115(int n) { return f114(n + v115) + 1; }
static int v116 = 116;
static int f116(int n) { return f115(n + v116) + 2; }
static int v117 = 117;
static int f117(int n) { return f116(n + v117) + 0; }
static int v118 = 118;
static int f118(int n) { return f117(n + v118) + 1; }
static int v119 = 119;
static int f119(int n) { return f118(n + v119) + 2; }
static int v120 = 120;
static int f120(int n) { return f119(n + v120) + 0; }
static int v121 = 121;
static int f121(int n) { return f120(n + v121) + 1; }
static int v122 = 122;
static int f122(int n) { return f121(n + v122) + 2; }
static int v123 = 123;
static int f123(int n) { return f122(n + v123) + 0; }
static int v124 = 124;
static int f124(int n) { return f123(n + v124) + 1; }
static int v125 = 125;
static int f125(int n) { return f124(n + v125) + 2; }
static int v126 = 126;
static int f126(int n) { return f125(n + v126) + 0; }
static int v127 = 127;
static int f127(int n) { return f126(n + v127) + 1; }
static int v128 = 128;
static int f128(int n) { return f127(n + v128) + 2; }
static int v129 = 129;
static int f129(int n) { return f128(n + v129) + 0; }
static int v130 = 130;
static int f130(int n) { return f129(n + v130) + 1; }
static int v131 = 131;
static int f131(int n) { return f130(n + v131) + 2; }
static int v132 = 132;
static int f132(int n) { return f131(n + v132) + 0; }
static int v133 = 133;
static int f133(int n) { return f132(n + v133) + 1; }
static int v134 = 134;
static int f134(int n) { return f133(n + v134) + 2; }
static int v135 = 135;
static int f135(int n) { return f134(n + v135) + 0; }
static int v136 = 136;
static int f136(int n) { return f135(n + v136) + 1; }
static int v137 = 137;
static int f137(int n) { return f136(n + v137) + 2; }
static int v138 = 138;
static int f138(int n) { return f137(n + v138) + 0; }
static int v139 = 139;
static int f139(int n) { return f138(n + v139) + 1; }
static int v140 = 140;
static int f140(int n) { return f139(n + v140) + 2; }
static int v141 = 141;
static int f141(int n) { return f140(n + v141) + 0; }
static int v142 = 142;
static int f142(int n) { return f141(n + v142) + 1; }
static int v143 = 143;
static int f143(int n) { return f142(n + v143) + 2; }
static int v144 = 144;
static int f144(int n) { return f143(n + v144) + 0; }
static int v145 = 145;
static int f145(int n) { return f144(n + v145) + 1; }
static int v146 = 146;
static int f146(int n) { return f145(n + v146) + 2; }
static int v147 = 147;
static int f147(int n) { return f146(n + v147) + 0; }
static int v148 = 148;
static int f148(int n) { return f147(n + v148) + 1; }
static int v149 = 149;
static int f149(int n) { return f148(n + v149) + 2; }
static int v150 = 150;
static int f150(int n) { return f149(n + v150) + 0; }
static int v151 = 151;
static int f151(int n) { return f150(n + v151) + 1; }
static int v152 = 152;
static int f152(int n) { return f151(n + v152) + 2; }
static int v153 = 153;
static int f153(int n) { return f152(n + v153) + 0; }
static int v154 = 154;
static int f154(int n) { return f153(n + v154) + 1; }
static int v155 = 155;
static int f155(int n) { return f154(n + v155) + 2; }
static int v156 = 156;
static int f156(int n) { return f155(n + v156) + 0; }
static int v157 = 157;
static int f157(int n) { return f156(n + v157) + 1; }
static int v158 = 158;
static int f158(int n) { return f157(n + v158) + 2; }
static int v159 = 159;
static int f159(int n) { return f158(n + v159) + 0; }
static int v160 = 160;
static int f160(int n) { return f159(n + v160) + 1; }
static int v161 = 161;
static int f161(int n) { return f160(n + v161) + 2; }
static int v162 = 162;
static int f162(int n) { return f161(n + v162) + 0; }
static int v163 = 163;
static int f163(int n) { return f162(n + v163) + 1; }
static int v164 = 164;
static int f164(int n) { return f163(n + v164) + 2; }
static int v165 = 165;
static int f165(int n) { return f164(n + v165) + 0; }
static int v166 = 166;
static int f166(int n) { return f165(n + v166) + 1; }
static int v167 = 167;
static int f167(int n) { return f166(n + v167) + 2; }
static int v168 = 168;
static int f168(int n) { return f167(n + v168) + 0; }
static int v169 = 169;
static int f169(int n) { return f168(n + v169) + 1; }
static int v170 = 170;
static int f170(int n) { return f169(n + v170) + 2; }
static int v171 = 171;
static int f171(int n) { return f170(n + v171) + 0; }
static int v172 = 172;
static int f172(int n) { return f171(n + v172) + 1; }
static int v173 = 173;
static int f173(int n) { return f172(n + v173) + 2; }
static int v174 = 174;
static int f174(int n) { return f173(n + v174) + 0; }
static int v175 = 175;
static int f175(int n) { return f174(n + v175) + 1; }
static int v176 = 176;
static int f176(int n) { return f175(n + v176) + 2; }
static int v177 = 177;
static int f177(int n) { return f176(n + v177) + 0; }
static int v178 = 178;
static int f178(int n) { return f177(n + v178) + 1; }
static int v179 = 179;
static int f179(int n) { return f178(n + v179) + 2; }
static int v180 = 180;
static int f180(int n) { return f179(n + v180) + 0; }
static int v181 = 181;
static int f181(int n) { return f180(n + v181) + 1; }
static int v182 = 182;
static int f182(int n) { return f181(n + v182) + 2; }
static int v183 = 183;
static int f183(int n) { return f182(n + v183) + 0; }
static int v184 = 184;
static int f184(int n) { return f183(n + v184) + 1; }
static int v185 = 185;
static int f185(int n) { return f184(n + v185) + 2; }
static int v186 = 186;
static int f186(int n) { return f185(n + v186) + 0; }
static int v187 = 187;
static int f187(int n) { return f186(n + v187) + 1; }
static int v188 = 188;
static int f188(int n) { return f187(n + v188) + 2; }
static int v189 = 189;
static int f189(int n) { return f188(n + v189) + 0; }
static int v190 = 190;
static int f190(int n) { return f189(n + v190) + 1; }
static int v191 = 191;
static int f191(int n) { return f190(n + v191) + 2; }
static int v192 = 192;
static int f192(int n) { return f191(n + v192) + 0; }
static int v193 = 193;
static int f193(int n) { return f192(n + v193) + 1; }
static int v194 = 194;
static int f194(int n) { return f193(n + v194) + 2; }
static int v195 = 195;
static int f195(int n) { return f194(n + v195) + 0; }
static int v196 = 196;
static int f196(int n) { return f195(n + v196) + 1; }
static int v197 = 197;
static int f197(int n) { return f196(n + v197) + 2; }
static int v198 = 198;
static int f198(int n) { return f197(n + v198) + 0; }
static int v199 = 199;
static int f199(int n) { return f198(n + v199) + 1; }
static int v200 = 200;
static int f200(int n) { return f199(n + v200) + 2; }
static int v201 = 201;
static int f201(int n) { return f200(n + v201) + 0; }
static int v202 = 202;
static int f202(int n) { return f201(n + v202) + 1; }
static int v203 = 203;
static int f203(int n) { return f202(n + v203) + 2; }
static int v204 = 204;
static int f204(int n) { return f203(n + v204) + 0; }
static int v205 = 205;
static int f205(int n) { return f204(n + v205) + 1; }
static int v206 = 206;
static int f206(int n) { return f205(n + v206) + 2; }
static int v207 = 207;
static int f207(int n) { return f206(n + v207) + 0; }
static int v208 = 208;
static int f208(int n) { return f207(n + v208) + 1; }
static int v209 = 209;
static int f209(int n) { return f208(n + v209) + 2; }
static int v210 = 210;
static int f210(int n) { return f209(n + v210) + 0; }
static int v211 = 211;
static int f211(int n) { return f210(n + v211) + 1; }
static int v212 = 212;
static int f212(int n) { return f211(n + v212) + 2; }
static int v213 = 213;
static int f213(int n) { return f212(n + v213) + 0; }
static int v214 = 214;
static int f214(int n) { return f213(n + v214) + 1; }
static int v215 = 215;
static int f215(int n) { return f214(n + v215) + 2; }
static int v216 = 216;
static int f216(int n) { return f215(n + v216) + 0; }
static int v217 = 217;
static int f217(int n) { return f216(n + v217) + 1; }
static int v218 = 218;
static int f218(int n) { return f217(n + v218) + 2; }
static int v219 = 219;
static int f219(int n) { return f218(n + v219) + 0; }
static int v220 = 220;
static int f220(int n) { return f219(n + v220) + 1; }
static int v221 = 221;
static int f221(int n) { return f220(n + v221) + 2; }
static int v222 = 222;
static int f222(int n) { return f221(n + v222) + 0; }
static int v223 = 223;
static int f223(int n) { return f222(n + v223) + 1; }
static int v224 = 224;
static int f224(int n) { return f223(n + v224) + 2; }
static int v225 = 225;
static int f225(int n) { return f224(n + v225) + 0; }
static int v226 = 226;
static int f226(int n) { return f225(n + v226) + 1; }
static int v227 = 227;
static int f227(int n) { return f226(n + v227) + 2; }
static int v228 = 228;
static int f228(int n) { return f227(n + v228) + 0; }
static int v229 = 229;
static int f229(int n) { return f228(n + v229) + 1; }
static int v230 = 230;
static int f230(int n) { return f229(n + v230) + 2; }
static int v231 = 231;
static int f231(int n) { return f230(n + v231) + 0; }
static int v232 = 232;
static int f232(int n) { return f231(n + v232) + 1; }
static int v233 = 233;
static int f233(int n) { return f232(n + v233) + 2; }
static int v234 = 234;
static int f234(int n) { return f233(n + v234) + 0; }
static int v235 = 235;
static int f235(int n) { return f234(n + v235) + 1; }
static int v236 = 236;
static int f236(int n) { return f235(n + v236) + 2; }
static int v237 = 237;
static int f237(int n) { return f236(n + v237) + 0; }
static int v238 = 238;
static int f238(int n) { return f237(n + v238) + 1; }
static int v239 = 239;
static int f239(int n) { return f238(n + v239) + 2; }
static int v240 = 240;
static int f240(int n) { return f239(n + v240) + 0; }
static int v241 = 241;
static int f241(int n) { return f240(n + v241) + 1; }
static int v242 = 242;
static int f242(int n) { return f241(n + v242) + 2; }
static int v243 = 243;
static int f243(int n) { return f242(n + v243) + 0; }
static int v244 = 244;
static int f244(int n) { return f243(n + v244) + 1; }
static int v245 = 245;
static int f245(int n) { return f244(n + v245) + 2; }
static int v246 = 246;
static int f246(int n) { return f245(n + v246) + 0; }
static int v247 = 247;
static int f247(int n) { return f246(n + v247) + 1; }
static int v248 = 248;
static int f248(int n) { return f247(n + v248) + 2; }
static int v249 = 249;
static int f249(int n) { return f248(n + v249) + 0; }
static int v250 = 250;
static int f250(int n) { return f249(n + v250) + 1; }
static int v251 = 251;
static int f251(int n) { return f250(n + v251) + 2; }
static int v252 = 252;
static int f252(int n) { return f251(n + v252) + 0; }
static int v253 = 253;
static int f253(int n) { return f252(n + v253) + 1; }
static int v254 = 254;
static int f254(int n) { return f253(n + v254) + 2; }
static int v255 = 255;
static int f255(int n) { return f254(n + v255) + 0; }
static int v256 = 256;
static int f256(int n) { return f255(n + v256) + 1; }
static int v257 = 257;
static int f257(int n) { return f256(n + v257) + 2; }
static int v258 = 258;
static int f258(int n) { return f257(n + v258) + 0; }
static int v259 = 259;
static int f259(int n) { return f258(n + v259) + 1; }
static int v260 = 260;
static int f260(int n) { return f259(n + v260) + 2; }
static int v261 = 261;
static int f261(int n) { return f260(n + v261) + 0; }
static int v262 = 262;
static int f262(int n) { return f261(n + v262) + 1; }
static int v263 = 263;
static int f263(int n) { return f262(n + v263) + 2; }
static int v264 = 264;
static int f264(int n) { return f263(n + v264) + 0; }
static int v265 = 265;
static int f265(int n) { return f264(n + v265) + 1; }
static int v266 = 266;
static int f266(int n) { return f265(n + v266) + 2; }
static int v267 = 267;
static int f267(int n) { return f266(n + v267) + 0; }
static int v268 = 268;
static int f268(int n) { return f267(n + v268) + 1; }
static int v269 = 269;
static int f269(int n) { return f268(n + v269) + 2; }
static int v270 = 270;
static int f270(int n) { return f269(n + v270) + 0; }
static int v271 = 271;
static int f271(int n) { return f270(n + v271) + 1; }
static int v272 = 272;
static int f272(int n) { return f271(n + v272) + 2; }
static int v273 = 273;
static int f273(int n) { return f272(n + v273) + 0; }
static int v274 = 274;
static int f274(int n) { return f273(n + v274) + 1; }
static int v275 = 275;
static int f275(int n) { return f274(n + v275) + 2; }
static int v276 = 276;
static int f276(int n) { return f275(n + v276) + 0; }
static int v277 = 277;
static int f277(int n) { return f276(n + v277) + 1; }
static int v278 = 278;
static int f278(int n) { return f277(n + v278) + 2; }
static int v279 = 279;
static int f279(int n) { return f278(n + v279) + 0; }
static int v280 = 280;
static int f280(int n) { return f279(n + v280) + 1; }
static int v281 = 281;
static int f281(int n) { return f280(n + v281) + 2; }
static int v282 = 282;
static int f282(int n) { return f281(n + v282) + 0; }
static int v283 = 283;
static int f283(int n) { return f282(n + v283) + 1; }
static int v284 = 284;
static int f284(int n) { return f283(n + v284) + 2; }
static int v285 = 285;
static int f285(int n) { return f284(n + v285) + 0; }
static int v286 = 286;
static int f286(int n) { return f285(n + v286) + 1; }
static int v287 = 287;
static int f287(int n) { return f286(n + v287) + 2; }
static int v288 = 288;
static int f288(int n) { return f287(n + v288) + 0; }
static int v289 = 289;
static int f289(int n) { return f288(n + v289) + 1; }
static int v290 = 290;
static int f290(int n) { return f289(n + v290) + 2; }
static int v291 = 291;
static int f291(int n) { return f290(n + v291) + 0; }
static int v292 = 292;
static int f292(int n) { return f291(n + v292) + 1; }
static int v293 = 293;
static int f293(int n) { return f292(n + v293) + 2; }
static int v294 = 294;
static int f294(int n) { return f293(n + v294) + 0; }
static int v295 = 295;
static int f295(int n) { return f294(n + v295) + 1; }
static int v296 = 296;
static int f296(int n) { return f295(n + v296) + 2; }
static int v297 = 297;
static int f297(int n) { return f296(n + v297) + 0; }
static int v298 = 298;
static int f298(int n) { return f297(n + v298) + 1; }
static int v299 = 299;
static int f299(int n) { return f298(n + v299) + 2; }
static int v300 = 300;
static int f300(int n) { return f299(n + v300) + 0; }
static int v301 = 301;
static int f301(int n) { return f300(n + v301) + 1; }
static int v302 = 302;
static int f302(int n) { return f301(n + v302) + 2; }
static int v303 = 303;
static int f303(int n) { return f302(n + v303) + 0; }
static int v304 = 304;
static int f304(int n) { return f303(n + v304) + 1; }
static int v305 = 305;
static int f305(int n) { return f304(n + v305) + 2; }
static int v306 = 306;
static int f306(int n) { return f305(n + v306) + 0; }
static int v307 = 307;
static int f307(int n) { return f306(n + v307) + 1; }
static int v308 = 308;
static int f308(int n) { return f307(n + v308) + 2; }
static int v309 = 309;
static int f309(int n) { return f308(n + v309) + 0; }
static int v310 = 310;
static int f310(int n) { return f309(n + v310) + 1; }
static int v311 = 311;
static int f311(int n) { return f310(n + v311) + 2; }
static int v312 = 312;
static int f312(int n) { return f311(n + v312) + 0; }
static int v313 = 313;
static int f313(int n) { return f312(n + v313) + 1; }
static int v314 = 314;
static int f314(int n) { return f313(n + v314) + 2; }
static int v315 = 315;
static int f315(int n) { return f314(n + v315) + 0; }
static int v316 = 316;
static int f316(int n) { return f315(n + v316) + 1; }
static int v317 = 317;
static int f317(int n) { return f316(n + v317) + 2; }
static int v318 = 318;
static int f318(int n) { return f317(n + v318) + 0; }
static int v319 = 319;
static int f319(int n) { return f318(n + v319) + 1; }
static int v320 = 320;
static int f320(int n) { return f319(n + v320) + 2; }
static int v321 = 321;
static int f321(int n) { return f320(n + v321) + 0; }
static int v322 = 322;
static int f322(int n) { return f321(n + v322) + 1; }
static int v323 = 323;
static int f323(int n) { return f322(n + v323) + 2; }
static int v324 = 324;
static int f324(int n) { return f323(n + v324) + 0; }
static int v325 = 325;
static int f325(int n) { return f324(n + v325) + 1; }
static int v326 = 326;
static int f326(int n) { return f325(n + v326) + 2; }
static int v327 = 327;
static int f327(int n) { return f326(n + v327) + 0; }
static int v328 = 328;
static int f328(int n) { return f327(n + v328) + 1; }
static int v329 = 329;
static int f329(int n) { return f328(n + v329) + 2; }
static int v330 = 330;
static int f330(int n) { return f329(n + v330) + 0; }
static int v331 = 331;
static int f331(int n) { return f330(n + v331) + 1; }
static int v332 = 332;
static int f332(int n) { return f331(n + v332) + 2; }
static int v333 = 333;
static int f333(int n) { return f332(n + v333) + 0; }
static int v334 = 334;
static int f334(int n) { return f333(n + v334) + 1; }
static int v335 = 335;
static int f335(int n) { return f334(n + v335) + 2; }
static int v336 = 336;
static int f336(int n) { return f335(n + v336) + 0; }
static int v337 = 337;
static int f337(int n) { return f336(n + v337) + 1; }
static int v338 = 338;
static int f338(int n) { return f337(n + v338) + 2; }
static int v339 = 339;
static int f339(int n) { return f338(n + v339) + 0; }
static int v340 = 340;
static int f340(int n) { return f339(n + v340) + 1; }
static int v341 = 341;
static int f341(int n) { return f340(n + v341) + 2; }
static int v342 = 342;
static int f342(int n) { return f341(n + v342) + 0; }
static int v343 = 343;
static int f343(int n) { return f342(n + v343) + 1; }
static int v344 = 344;
static int f344(int n) { return f343(n + v344) + 2; }
static int v345 = 345;
static int f345(int n) { return f344(n + v345) + 0; }
static int v346 = 346;
static int f346(int n) { return f345(n + v346) + 1; }
static int v347 = 347;
static int f347(int n) { return f346(n + v347) + 2; }
static int v348 = 348;
static int f348(int n) { return f347(n + v348) + 0; }
static int v349 = 349;
static int f349(int n) { return f348(n + v349) + 1; }
static int v350 = 350;
static int f350(int n) { return f349(n + v350) + 2; }
static int v351 = 351;
static int f351(int n) { return f350(n + v351) + 0; }
static int v352 = 352;
static int f352(int n) { return f351(n + v352) + 1; }
static int v353 = 353;
static int f353(int n) { return f352(n + v353) + 2; }
static int v354 = 354;
static int f354(int n) { return f353(n + v354) + 0; }
static int v355 = 355;
static int f355(int n) { return f354(n + v355) + 1; }
static int v356 = 356;
static int f356(int n) { return f355(n + v356) + 2; }
static int v357 = 357;
static int f357(int n) { return f356(n + v357) + 0; }
static int v358 = 358;
static int f358(int n) { return f357(n + v358) + 1; }
static int v359 = 359;
static int f359(int n) { return f358(n + v359) + 2; }
static int v360 = 360;
static int f360(int n) { return f359(n + v360) + 0; }
static int v361 = 361;
static int f361(int n) { return f360(n + v361) + 1; }
static int v362 = 362;
static int f362(int n) { return f361(n + v362) + 2; }
static int v363 = 363;
static int f363(int n) { return f362(n + v363) + 0; }
static int v364 = 364;
static int f364(int n) { return f363(n + v364) + 1; }
static int v365 = 365;
static int f365(int n) { return f364(n + v365) + 2; }
static int v366 = 366;
static int f366(int n) { return f365(n + v366) + 0; }
static int v367 = 367;
static int f367(int n) { return f366(n + v367) + 1; }
static int v368 = 368;
static int f368(int n) { return f367(n + v368) + 2; }
static int v369 = 369;
static int f369(int n) { return f368(n + v369) + 0; }
static int v370 = 370;
static int f370(int n) { return f369(n + v370) + 1; }
static int v371 = 371;
static int f371(int n) { return f370(n + v371) + 2; }
static int v372 = 372;
static int f372(int n) { return f371(n + v372) + 0; }
static int v373 = 373;
static int f373(int n) { return f372(n + v373) + 1; }
static int v374 = 374;
static int f374(int n) { return f373(n + v374) + 2; }
static int v375 = 375;
static int f375(int n) { return f374(n + v375) + 0; }
static int v376 = 376;
static int f376(int n) { return f375(n + v376) + 1; }
static int v377 = 377;
static int f377(int n) { return f376(n + v377) + 2; }
static int v378 = 378;
static int f378(int n) { return f377(n + v378) + 0; }
static int v379 = 379;
static int f379(int n) { return f378(n + v379) + 1; }
static int v380 = 380;
static int f380(int n) { return f379(n + v380) + 2; }
static int v381 = 381;
static int f381(int n) { return f380(n + v381) + 0; }
static int v382 = 382;
static int f382(int n) { return f381(n + v382) + 1; }
static int v383 = 383;
static int f383(int n) { return f382(n + v383) + 2; }
static int v384 = 384;
static int f384(int n) { return f383(n + v384) + 0; }
static int v385 = 385;
static int f385(int n) { return f384(n + v385) + 1; }
static int v386 = 386;
static int f386(int n) { return f385(n + v386) + 2; }
static int v387 = 387;
static int f387(int n) { return f386(n + v387) + 0; }
static int v388 = 388;
static int f388(int n) { return f387(n + v388) + 1; }
static int v389 = 389;
static int f389(int n) { return f388(n + v389) + 2; }
static int v390 = 390;
static int f390(int n) { return f389(n + v390) + 0; }
static int v391 = 391;
static int f391(int n) { return f390(n + v391) + 1; }
static int v392 = 392;
static int f392(int n) { return f391(n + v392) + 2; }
static int v393 = 393;
static int f393(int n) { return f392(n + v393) + 0; }
static int v394 = 394;
static int f394(int n) { return f393(n + v394) + 1; }
static int v395 = 395;
static int f395(int n) { return f394(n + v395) + 2; }
static int v396 = 396;
static int f396(int n) { return f395(n + v396) + 0; }
static int v397 = 397;
static int f397(int n) { return f396(n + v397) + 1; }
static int v398 = 398;
static int f398(int n) { return f397(n + v398) + 2; }
static int v399 = 399;
static int f399(int n) { return f398(n + v399) + 0; }
static int v400 = 400;
static int f400(int n) { return f399(n + v400) + 1; }
static int v401 = 401;
static int f401(int n) { return f400(n + v401) + 2; }
static int v402 = 402;
static int f402(int n) { return f401(n + v402) + 0; }
static int v403 = 403;
static int f403(int n) { return f402(n + v403) + 1; }
static int v404 = 404;
static int f404(int n) { return f403(n + v404) + 2; }
static int v405 = 405;
static int f405(int n) { return f404(n + v405) + 0; }
static int v406 = 406;
static int f406(int n) { return f405(n + v406) + 1; }
static int v407 = 407;
static int f407(int n) { return f406(n + v407) + 2; }
static int v408 = 408;
static int f408(int n) { return f407(n + v408) + 0; }
static int v409 = 409;
static int f409(int n) { return f408(n + v409) + 1; }
static int v410 = 410;
static int f410(int n) { return f409(n + v410) + 2; }
static int v411 = 411;
static int f411(int n) { return f410(n + v411) + 0; }
static int v412 = 412;
static int f412(int n) { return f411(n + v412) + 1; }
static int v413 = 413;
static int f413(int n) { return f412(n + v413) + 2; }
static int v414 = 414;
static int f414(int n) { return f413(n + v414) + 0; }
static int v415 = 415;
static int f415(int n) { return f414(n + v415) + 1; }
static int v416 = 416;
static int f416(int n) { return f415(n + v416) + 2; }
static int v417 = 417;
static int f417(int n) { return f416(n + v417) + 0; }
static int v418 = 418;
static int f418(int n) { return f417(n + v418) + 1; }
static int v419 = 419;
static int f419(int n) { return f418(n + v419) + 2; }
static int v420 = 420;
static int f420(int n) { return f419(n + v420) + 0; }
static int v421 = 421;
static int f421(int n) { return f420(n + v421) + 1; }
static int v422 = 422;
static int f422(int n) { return f421(n + v422) + 2; }
static int v423 = 423;
static int f423(int n) { return f422(n + v423) + 0; }
static int v424 = 424;
static int f424(int n) { return f423(n + v424) + 1; }
static int v425 = 425;
static int f425(int n) { return f424(n + v425) + 2; }
static int v426 = 426;
static int f426(int n) { return f425(n + v426) + 0; }
static int v427 = 427;
static int f427(int n) { return f426(n + v427) + 1; }
static int v428 = 428;
static int f428(int n) { return f427(n + v428) + 2; }
static int v429 = 429;
static int f429(int n) { return f428(n + v429) + 0; }
static int v430 = 430;
static int f430(int n) { return f429(n + v430) + 1; }
static int v431 = 431;
static int f431(int n) { return f430(n + v431) + 2; }
static int v432 = 432;
static int f432(int n) { return f431(n + v432) + 0; }
static int v433 = 433;
static int f433(int n) { return f432(n + v433) + 1; }
static int v434 = 434;
static int f434(int n) { return f433(n + v434) + 2; }
static int v435 = 435;
static int f435(int n) { return f434(n + v435) + 0; }
static int v436 = 436;
static int f436(int n) { return f435(n + v436) + 1; }
static int v437 = 437;
static int f437(int n) { return f436(n + v437) + 2; }
static int v438 = 438;
static int f438(int n) { return f437(n + v438) + 0; }
static int v439 = 439;
static int f439(int n) { return f438(n + v439) + 1; }
static int v440 = 440;
static int f440(int n) { return f439(n + v440) + 2; }
static int v441 = 441;
static int f441(int n) { return f440(n + v441) + 0; }
static int v442 = 442;
static int f442(int n) { return f441(n + v442) + 1; }
static int v443 = 443;
static int f443(int n) { return f442(n + v443) + 2; }
static int v444 = 444;
static int f444(int n) { return f443(n + v444) + 0; }
static int v445 = 445;
static int f445(int n) { return f444(n + v445) + 1; }
static int v446 = 446;
static int f446(int n) { return f445(n + v446) + 2; }
static int v447 = 447;
static int f447(int n) { return f446(n + v447) + 0; }
static int v448 = 448;
static int f448(int n) { return f447(n + v448) + 1; }
static int v449 = 449;
static int f449(int n) { return f448(n + v449) + 2; }
static int v450 = 450;
static int f450(int n) { return f449(n + v450) + 0; }
static int v451 = 451;
static int f451(int n) { return f450(n + v451) + 1; }
static int v452 = 452;
static int f452(int n) { return f451(n + v452) + 2; }
static int v453 = 453;
static int f453(int n) { return f452(n + v453) + 0; }
static int v454 = 454;
static int f454(int n) { return f453(n + v454) + 1; }
static int v455 = 455;
static int f455(int n) { return f454(n + v455) + 2; }
static int v456 = 456;
static int f456(int n) { return f455(n + v456) + 0; }
static int v457 = 457;
static int f457(int n) { return f456(n + v457) + 1; }
static int v458 = 458;
static int f458(int n) { return f457(n + v458) + 2; }
static int v459 = 459;
static int f459(int n) { return f458(n + v459) + 0; }
static int v460 = 460;
static int f460(int n) { return f459(n + v460) + 1; }
static int v461 = 461;
static int f461(int n) { return f460(n + v461) + 2; }
static int v462 = 462;
static int f462(int n) { return f461(n + v462) + 0; }
static int v463 = 463;
static int f463(int n) { return f462(n + v463) + 1; }
static int v464 = 464;
static int f464(int n) { return f463(n + v464) + 2; }
static int v465 = 465;
static int f465(int n) { return f464(n + v465) + 0; }
static int v466 = 466;
static int f466(int n) { return f465(n + v466) + 1; }
static int v467 = 467;
static int f467(int n) { return f466(n + v467) + 2; }
static int v468 = 468;
static int f468(int n) { return f467(n + v468) + 0; }
static int v469 = 469;
static int f469(int n) { return f468(n + v469) + 1; }
static int v470 = 470;
static int f470(int n) { return f469(n + v470) + 2; }
static int v471 = 471;
static int f471(int n) { return f470(n + v471) + 0; }
static int v472 = 472;
static int f472(int n) { return f471(n + v472) + 1; }
static int v473 = 473;
static int f473(int n) { return f472(n + v473) + 2; }
static int v474 = 474;
static int f474(int n) { return f473(n + v474) + 0; }
static int v475 = 475;
static int f475(int n) { return f474(n + v475) + 1; }
static int v476 = 476;
static int f476(int n) { return f475(n + v476) + 2; }
static int v477 = 477;
static int f477(int n) { return f476(n + v477) + 0; }
static int v478 = 478;
static int f478(int n) { return f477(n + v478) + 1; }
static int v479 = 479;
static int f479(int n) { return f478(n + v479) + 2; }
static int v480 = 480;
static int f480(int n) { return f479(n + v480) + 0; }
static int v481 = 481;
static int f481(int n) { return f480(n + v481) + 1; }
static int v482 = 482;
static int f482(int n) { return f481(n + v482) + 2; }
static int v483 = 483;
static int f483(int n) { return f482(n + v483) + 0; }
static int v484 = 484;
static int f484(int n) { return f483(n + v484) + 1; }
static int v485 = 485;
static int f485(int n) { return f484(n + v485) + 2; }
static int v486 = 486;
static int f486(int n) { return f485(n + v486) + 0; }
static int v487 = 487;
static int f487(int n) { return f486(n + v487) + 1; }
static int v488 = 488;
static int f488(int n) { return f487(n + v488) + 2; }
static int v489 = 489;
static int f489(int n) { return f488(n + v489) + 0; }
static int v490 = 490;
static int f490(int n) { return f489(n + v490) + 1; }
static int v491 = 491;
static int f491(int n) { return f490(n + v491) + 2; }
static int v492 = 492;
static int f492(int n) { return f491(n + v492) + 0; }
static int v493 = 493;
static int f493(int n) { return f492(n + v493) + 1; }
static int v494 = 494;
static int f494(int n) { return f493(n + v494) + 2; }
static int v495 = 495;
static int f495(int n) { return f494(n + v495) + 0; }
static int v496 = 496;
static int f496(int n) { return f495(n + v496) + 1; }
static int v497 = 497;
static int f497(int n) { return f496(n + v497) + 2; }
static int v498 = 498;
static int f498(int n) { return f497(n + v498) + 0; }
static int v499 = 499;
static int f499(int n) { return f498(n + v499) + 1; }

int main(void)
{
    int (*last)(int) = f499;

    printf("%d\n", last(1));
    return 0;
}
