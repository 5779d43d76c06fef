/* A chain of a thousand branches. */
#include <stdio.h>

static int choose(int n)
{
    if (n == 0)
        return 0;
    else if (n == 7)
        return 1;
    else if (n == 14)
        return 2;
    else if (n == 21)
        return 3;
    else if (n == 28)
        return 4;
    else if (n == 35)
        return 5;
    else if (n == 42)
        return 6;
    else if (n == 49)
        return 7;
    else if (n == 56)
        return 8;
    else if (n == 63)
        return 9;
    else if (n == 70)
        return 10;
    else if (n == 77)
        return 11;
    else if (n == 84)
        return 12;
    else if (n == 91)
        return 13;
    else if (n == 98)
        return 14;
    else if (n == 105)
        return 15;
    else if (n == 112)
        return 16;
    else if (n == 119)
        return 17;
    else if (n == 126)
        return 18;
    else if (n == 133)
        return 19;
    else if (n == 140)
        return 20;
    else if (n == 147)
        return 21;
    else if (n == 154)
        return 22;
    else if (n == 161)
        return 23;
    else if (n == 168)
        return 24;
    else if (n == 175)
        return 25;
    else if (n == 182)
        return 26;
    else if (n == 189)
        return 27;
    else if (n == 196)
        return 28;
    else if (n == 203)
        return 29;
    else if (n == 210)
        return 30;
    else if (n == 217)
        return 31;
    else if (n == 224)
        return 32;
    else if (n == 231)
        return 33;
    else if (n == 238)
        return 34;
    else if (n == 245)
        return 35;
    else if (n == 252)
        return 36;
    else if (n == 259)
        return 37;
    else if (n == 266)
        return 38;
    else if (n == 273)
        return 39;
    else if (n == 280)
        return 40;
    else if (n == 287)
        return 41;
    else if (n == 294)
        return 42;
    else if (n == 301)
        return 43;
    else if (n == 308)
        return 44;
    else if (n == 315)
        return 45;
    else if (n == 322)
        return 46;
    else if (n == 329)
        return 47;
    else if (n == 336)
        return 48;
    else if (n == 343)
        return 49;
    else if (n == 350)
        return 50;
    else if (n == 357)
        return 51;
    else if (n == 364)
        return 52;
    else if (n == 371)
        return 53;
    else if (n == 378)
        return 54;
    else if (n == 385)
        return 55;
    else if (n == 392)
        return 56;
    else if (n == 399)
        return 57;
    else if (n == 406)
        return 58;
    else if (n == 413)
        return 59;
    else if (n == 420)
        return 60;
    else if (n == 427)
        return 61;
    else if (n == 434)
        return 62;
    else if (n == 441)
        return 63;
    else if (n == 448)
        return 64;
    else if (n == 455)
        return 65;
    else if (n == 462)
        return 66;
    else if (n == 469)
        return 67;
    else if (n == 476)
        return 68;
    else if (n == 483)
        return 69;
    else if (n == 490)
        return 70;
    else if (n == 497)
        return 71;
    else if (n == 504)
        return 72;
    else if (n == 511)
        return 73;
    else if (n == 518)
        return 74;
    else if (n == 525)
        return 75;
    else if (n == 532)
        return 76;
    else if (n == 539)
        return 77;
    else if (n == 546)
        return 78;
    else if (n == 553)
        return 79;
    else if (n == 560)
        return 80;
    else if (n == 567)
        return 81;
    else if (n == 574)
        return 82;
    else if (n == 581)
        return 83;
    else if (n == 588)
        return 84;
    else if (n == 595)
        return 85;
    else if (n == 602)
        return 86;
    else if (n == 609)
        return 87;
    else if (n == 616)
        return 88;
    else if (n == 623)
        return 89;
    else if (n == 630)
        return 90;
    else if (n == 637)
        return 91;
    else if (n == 644)
        return 92;
    else if (n == 651)
        return 93;
    else if (n == 658)
        return 94;
    else if (n == 665)
        return 95;
    else if (n == 672)
        return 96;
    else if (n == 679)
        return 97;
    else if (n == 686)
        return 98;
    else if (n == 693)
        return 99;
    else if (n == 700)
        return 0;
    else if (n == 707)
        return 1;
    else if (n == 714)
        return 2;
    else if (n == 721)
        return 3;
    else if (n == 728)
        return 4;
    else if (n == 735)
        return 5;
    else if (n == 742)
        return 6;
    else if (n == 749)
        return 7;
    else if (n == 756)
        return 8;
    else if (n == 763)
        return 9;
    else if (n == 770)
        return 10;
    else if (n == 777)
        return 11;
    else if (n == 784)
        return 12;
    else if (n == 791)
        return 13;
    else if (n == 798)
        return 14;
    else if (n == 805)
        return 15;
    else if (n == 812)
        return 16;
    else if (n == 819)
        return 17;
    else if (n == 826)
        return 18;
    else if (n == 833)
        return 19;
    else if (n == 840)
        return 20;
    else if (n == 847)
        return 21;
    else if (n == 854)
        return 22;
    else if (n == 861)
        return 23;
    else if (n == 868)
        return 24;
    else if (n == 875)
        return 25;
    else if (n == 882)
        return 26;
    else if (n == 889)
        return 27;
    else if (n == 896)
        return 28;
    else if (n == 903)
        return 29;
    else if (n == 910)
        return 30;
    else if (n == 917)
        return 31;
    else if (n == 924)
        return 32;
    else if (n == 931)
        return 33;
    else if (n == 938)
        return 34;
    else if (n == 945)
        return 35;
    else if (n == 952)
        return 36;
    else if (n == 959)
        return 37;
    else if (n == 966)
        return 38;
    else if (n == 973)
        return 39;
    else if (n == 980)
        return 40;
    else if (n == 987)
        return 41;
    else if (n == 994)
        return 42;
    else if (n == 1001)
        return 43;
    else if (n == 1008)
        return 44;
    else if (n == 6)
        return 45;
    else if (n == 13)
        return 46;
    else if (n == 20)
        return 47;
    else if (n == 27)
        return 48;
    else if (n == 34)
        return 49;
    else if (n == 41)
        return 50;
    else if (n == 48)
        return 51;
    else if (n == 55)
        return 52;
    else if (n == 62)
        return 53;
    else if (n == 69)
        return 54;
    else if (n == 76)
        return 55;
    else if (n == 83)
        return 56;
    else if (n == 90)
        return 57;
    else if (n == 97)
        return 58;
    else if (n == 104)
        return 59;
    else if (n == 111)
        return 60;
    else if (n == 118)
        return 61;
    else if (n == 125)
        return 62;
    else if (n == 132)
        return 63;
    else if (n == 139)
        return 64;
    else if (n == 146)
        return 65;
    else if (n == 153)
        return 66;
    else if (n == 160)
        return 67;
    else if (n == 167)
        return 68;
    else if (n == 174)
        return 69;
    else if (n == 181)
        return 70;
    else if (n == 188)
        return 71;
    else if (n == 195)
        return 72;
    else if (n == 202)
        return 73;
    else if (n == 209)
        return 74;
    else if (n == 216)
        return 75;
    else if (n == 223)
        return 76;
    else if (n == 230)
        return 77;
    else if (n == 237)
        return 78;
    else if (n == 244)
        return 79;
    else if (n == 251)
        return 80;
    else if (n == 258)
        return 81;
    else if (n == 265)
        return 82;
    else if (n == 272)
        return 83;
    else if (n == 279)
        return 84;
    else if (n == 286)
        return 85;
    else if (n == 293)
        return 86;
    else if (n == 300)
        return 87;
    else if (n == 307)
        return 88;
    else if (n == 314)
        return 89;
    else if (n == 321)
        return 90;
    else if (n == 328)
        return 91;
    else if (n == 335)
        return 92;
    else if (n == 342)
        return 93;
    else if (n == 349)
        return 94;
    else if (n == 356)
        return 95;
    else if (n == 363)
        return 96;
    else if (n == 370)
        return 97;
    else if (n == 377)
        return 98;
    else if (n == 384)
        return 99;
    else if (n == 391)
        return 0;
    else if (n == 398)
        return 1;
    else if (n == 405)
        return 2;
    else if (n == 412)
        return 3;
    else if (n == 419)
        return 4;
    else if (n == 426)
        return 5;
    else if (n == 433)
        return 6;
    else if (n == 440)
        return 7;
    else if (n == 447)
        return 8;
    else if (n == 454)
        return 9;
    else if (n == 461)
        return 10;
    else if (n == 468)
        return 11;
    else if (n == 475)
        return 12;
    else if (n == 482)
        return 13;
    else if (n == 489)
        return 14;
    else if (n == 496)
        return 15;
    else if (n == 503)
        return 16;
    else if (n == 510)
        return 17;
    else if (n == 517)
        return 18;
    else if (n == 524)
        return 19;
    else if (n == 531)
        return 20;
    else if (n == 538)
        return 21;
    else if (n == 545)
        return 22;
    else if (n == 552)
        return 23;
    else if (n == 559)
        return 24;
    else if (n == 566)
        return 25;
    else if (n == 573)
        return 26;
    else if (n == 580)
        return 27;
    else if (n == 587)
        return 28;
    else if (n == 594)
        return 29;
    else if (n == 601)
        return 30;
    else if (n == 608)
        return 31;
    else if (n == 615)
        return 32;
    else if (n == 622)
        return 33;
    else if (n == 629)
        return 34;
    else if (n == 636)
        return 35;
    else if (n == 643)
        return 36;
    else if (n == 650)
        return 37;
    else if (n == 657)
        return 38;
    else if (n == 664)
        return 39;
    else if (n == 671)
        return 40;
    else if (n == 678)
        return 41;
    else if (n == 685)
        return 42;
    else if (n == 692)
        return 43;
    else if (n == 699)
        return 44;
    else if (n == 706)
        return 45;
    else if (n == 713)
        return 46;
    else if (n == 720)
        return 47;
    else if (n == 727)
        return 48;
    else if (n == 734)
        return 49;
    else if (n == 741)
        return 50;
    else if (n == 748)
        return 51;
    else if (n == 755)
        return 52;
    else if (n == 762)
        return 53;
    else if (n == 769)
        return 54;
    else if (n == 776)
        return 55;
    else if (n == 783)
        return 56;
    else if (n == 790)
        return 57;
    else if (n == 797)
        return 58;
    else if (n == 804)
        return 59;
    else if (n == 811)
        return 60;
    else if (n == 818)
        return 61;
    else if (n == 825)
        return 62;
    else if (n == 832)
        return 63;
    else if (n == 839)
        return 64;
    else if (n == 846)
        return 65;
    else if (n == 853)
        return 66;
    else if (n == 860)
        return 67;
    else if (n == 867)
        return 68;
    else if (n == 874)
        return 69;
    else if (n == 881)
        return 70;
    else if (n == 888)
        return 71;
    else if (n == 895)
        return 72;
    else if (n == 902)
        return 73;
    else if (n == 909)
        return 74;
    else if (n == 916)
        return 75;
    else if (n == 923)
        return 76;
    else if (n == 930)
        return 77;
    else if (n == 937)
        return 78;
    else if (n == 944)
        return 79;
    else if (n == 951)
        return 80;
    else if (n == 958)
        return 81;
    else if (n == 965)
        return 82;
    else if (n == 972)
        return 83;
    else if (n == 979)
        return 84;
    else if (n == 986)
        return 85;
    else if (n == 993)
        return 86;
    else if (n == 1000)
        return 87;
    else if (n == 1007)
        return 88;
    else if (n == 5)
        return 89;
    else if (n == 12)
        return 90;
    else if (n == 19)
        return 91;
    else if (n == 26)
        return 92;
    else if (n == 33)
        return 93;
    else if (n == 40)
        return 94;
    else if (n == 47)
        return 95;
    else if (n == 54)
        return 96;
    else if (n == 61)
        return 97;
    else if (n == 68)
        return 98;
    else if (n == 75)
        return 99;
    else if (n == 82)
        return 0;
    else if (n == 89)
        return 1;
    else if (n == 96)
        return 2;
    else if (n == 103)
        return 3;
    else if (n == 110)
        return 4;
    else if (n == 117)
        return 5;
    else if (n == 124)
        return 6;
    else if (n == 131)
        return 7;
    else if (n == 138)
        return 8;
    else if (n == 145)
        return 9;
    else if (n == 152)
        return 10;
    else if (n == 159)
        return 11;
    else if (n == 166)
        return 12;
    else if (n == 173)
        return 13;
    else if (n == 180)
        return 14;
    else if (n == 187)
        return 15;
    else if (n == 194)
        return 16;
    else if (n == 201)
        return 17;
    else if (n == 208)
        return 18;
    else if (n == 215)
        return 19;
    else if (n == 222)
        return 20;
    else if (n == 229)
        return 21;
    else if (n == 236)
        return 22;
    else if (n == 243)
        return 23;
    else if (n == 250)
        return 24;
    else if (n == 257)
        return 25;
    else if (n == 264)
        return 26;
    else if (n == 271)
        return 27;
    else if (n == 278)
        return 28;
    else if (n == 285)
        return 29;
    else if (n == 292)
        return 30;
    else if (n == 299)
        return 31;
    else if (n == 306)
        return 32;
    else if (n == 313)
        return 33;
    else if (n == 320)
        return 34;
    else if (n == 327)
        return 35;
    else if (n == 334)
        return 36;
    else if (n == 341)
        return 37;
    else if (n == 348)
        return 38;
    else if (n == 355)
        return 39;
    else if (n == 362)
        return 40;
    else if (n == 369)
        return 41;
    else if (n == 376)
        return 42;
    else if (n == 383)
        return 43;
    else if (n == 390)
        return 44;
    else if (n == 397)
        return 45;
    else if (n == 404)
        return 46;
    else if (n == 411)
        return 47;
    else if (n == 418)
        return 48;
    else if (n == 425)
        return 49;
    else if (n == 432)
        return 50;
    else if (n == 439)
        return 51;
    else if (n == 446)
        return 52;
    else if (n == 453)
        return 53;
    else if (n == 460)
        return 54;
    else if (n == 467)
        return 55;
    else if (n == 474)
        return 56;
    else if (n == 481)
        return 57;
    else if (n == 488)
        return 58;
    else if (n == 495)
        return 59;
    else if (n == 502)
        return 60;
    else if (n == 509)
        return 61;
    else if (n == 516)
        return 62;
    else if (n == 523)
        return 63;
    else if (n == 530)
        return 64;
    else if (n == 537)
        return 65;
    else if (n == 544)
        return 66;
    else if (n == 551)
        return 67;
    else if (n == 558)
        return 68;
    else if (n == 565)
        return 69;
    else if (n == 572)
        return 70;
    else if (n == 579)
        return 71;
    else if (n == 586)
        return 72;
    else if (n == 593)
        return 73;
    else if (n == 600)
        return 74;
    else if (n == 607)
        return 75;
    else if (n == 614)
        return 76;
    else if (n == 621)
        return 77;
    else if (n == 628)
        return 78;
    else if (n == 635)
        return 79;
    else if (n == 642)
        return 80;
    else if (n == 649)
        return 81;
    else if (n == 656)
        return 82;
    else if (n == 663)
        return 83;
    else if (n == 670)
        return 84;
    else if (n == 677)
        return 85;
    else if (n == 684)
        return 86;
    else if (n == 691)
        return 87;
    else if (n == 698)
        return 88;
    else if (n == 705)
        return 89;
    else if (n == 712)
        return 90;
    else if (n == 719)
        return 91;
    else if (n == 726)
        return 92;
    else if (n == 733)
        return 93;
    else if (n == 740)
        return 94;
    else if (n == 747)
        return 95;
    else if (n == 754)
        return 96;
    else if (n == 761)
        return 97;
    else if (n == 768)
        return 98;
    else if (n == 775)
        return 99;
    else if (n == 782)
        return 0;
    else if (n == 789)
        return 1;
    else if (n == 796)
        return 2;
    else if (n == 803)
        return 3;
    else if (n == 810)
        return 4;
    else if (n == 817)
        return 5;
    else if (n == 824)
        return 6;
    else if (n == 831)
        return 7;
    else if (n == 838)
        return 8;
    else if (n == 845)
        return 9;
    else if (n == 852)
        return 10;
    else if (n == 859)
        return 11;
    else if (n == 866)
        return 12;
    else if (n == 873)
        return 13;
    else if (n == 880)
        return 14;
    else if (n == 887)
        return 15;
    else if (n == 894)
        return 16;
    else if (n == 901)
        return 17;
    else if (n == 908)
        return 18;
    else if (n == 915)
        return 19;
    else if (n == 922)
        return 20;
    else if (n == 929)
        return 21;
    else if (n == 936)
        return 22;
    else if (n == 943)
        return 23;
    else if (n == 950)
        return 24;
    else if (n == 957)
        return 25;
    else if (n == 964)
        return 26;
    else if (n == 971)
        return 27;
    else if (n == 978)
        return 28;
    else if (n == 985)
        return 29;
    else if (n == 992)
        return 30;
    else if (n == 999)
        return 31;
    else if (n == 1006)
        return 32;
    else if (n == 4)
        return 33;
    else if (n == 11)
        return 34;
    else if (n == 18)
        return 35;
    else if (n == 25)
        return 36;
    else if (n == 32)
        return 37;
    else if (n == 39)
        return 38;
    else if (n == 46)
        return 39;
    else if (n == 53)
        return 40;
    else if (n == 60)
        return 41;
    else if (n == 67)
        return 42;
    else if (n == 74)
        return 43;
    else if (n == 81)
        return 44;
    else if (n == 88)
        return 45;
    else if (n == 95)
        return 46;
    else if (n == 102)
        return 47;
    else if (n == 109)
        return 48;
    else if (n == 116)
        return 49;
    else if (n == 123)
        return 50;
    else if (n == 130)
        return 51;
    else if (n == 137)
        return 52;
    else if (n == 144)
        return 53;
    else if (n == 151)
        return 54;
    else if (n == 158)
        return 55;
    else if (n == 165)
        return 56;
    else if (n == 172)
        return 57;
    else if (n == 179)
        return 58;
    else if (n == 186)
        return 59;
    else if (n == 193)
        return 60;
    else if (n == 200)
        return 61;
    else if (n == 207)
        return 62;
    else if (n == 214)
        return 63;
    else if (n == 221)
        return 64;
    else if (n == 228)
        return 65;
    else if (n == 235)
        return 66;
    else if (n == 242)
        return 67;
    else if (n == 249)
        return 68;
    else if (n == 256)
        return 69;
    else if (n == 263)
        return 70;
    else if (n == 270)
        return 71;
    else if (n == 277)
        return 72;
    else if (n == 284)
        return 73;
    else if (n == 291)
        return 74;
    else if (n == 298)
        return 75;
    else if (n == 305)
        return 76;
    else if (n == 312)
        return 77;
    else if (n == 319)
        return 78;
    else if (n == 326)
        return 79;
    else if (n == 333)
        return 80;
    else if (n == 340)
        return 81;
    else if (n == 347)
        return 82;
    else if (n == 354)
        return 83;
    else if (n == 361)
        return 84;
    else if (n == 368)
        return 85;
    else if (n == 375)
        return 86;
    else if (n == 382)
        return 87;
    else if (n == 389)
        return 88;
    else if (n == 396)
        return 89;
    else if (n == 403)
        return 90;
    else if (n == 410)
        return 91;
    else if (n == 417)
        return 92;
    else if (n == 424)
        return 93;
    else if (n == 431)
        return 94;
    else if (n == 438)
        return 95;
    else if (n == 445)
        return 96;
    else if (n == 452)
        return 97;
    else if (n == 459)
        return 98;
    else if (n == 466)
        return 99;
    else if (n == 473)
        return 0;
    else if (n == 480)
        return 1;
    else if (n == 487)
        return 2;
    else if (n == 494)
        return 3;
    else if (n == 501)
        return 4;
    else if (n == 508)
        return 5;
    else if (n == 515)
        return 6;
    else if (n == 522)
        return 7;
    else if (n == 529)
        return 8;
    else if (n == 536)
        return 9;
    else if (n == 543)
        return 10;
    else if (n == 550)
        return 11;
    else if (n == 557)
        return 12;
    else if (n == 564)
        return 13;
    else if (n == 571)
        return 14;
    else if (n == 578)
        return 15;
    else if (n == 585)
        return 16;
    else if (n == 592)
        return 17;
    else if (n == 599)
        return 18;
    else if (n == 606)
        return 19;
    else if (n == 613)
        return 20;
    else if (n == 620)
        return 21;
    else if (n == 627)
        return 22;
    else if (n == 634)
        return 23;
    else if (n == 641)
        return 24;
    else if (n == 648)
        return 25;
    else if (n == 655)
        return 26;
    else if (n == 662)
        return 27;
    else if (n == 669)
        return 28;
    else if (n == 676)
        return 29;
    else if (n == 683)
        return 30;
    else if (n == 690)
        return 31;
    else if (n == 697)
        return 32;
    else if (n == 704)
        return 33;
    else if (n == 711)
        return 34;
    else if (n == 718)
        return 35;
    else if (n == 725)
        return 36;
    else if (n == 732)
        return 37;
    else if (n == 739)
        return 38;
    else if (n == 746)
        return 39;
    else if (n == 753)
        return 40;
    else if (n == 760)
        return 41;
    else if (n == 767)
        return 42;
    else if (n == 774)
        return 43;
    else if (n == 781)
        return 44;
    else if (n == 788)
        return 45;
    else if (n == 795)
        return 46;
    else if (n == 802)
        return 47;
    else if (n == 809)
        return 48;
    else if (n == 816)
        return 49;
    else if (n == 823)
        return 50;
    else if (n == 830)
        return 51;
    else if (n == 837)
        return 52;
    else if (n == 844)
        return 53;
    else if (n == 851)
        return 54;
    else if (n == 858)
        return 55;
    else if (n == 865)
        return 56;
    else if (n == 872)
        return 57;
    else if (n == 879)
        return 58;
    else if (n == 886)
        return 59;
    else if (n == 893)
        return 60;
    else if (n == 900)
        return 61;
    else if (n == 907)
        return 62;
    else if (n == 914)
        return 63;
    else if (n == 921)
        return 64;
    else if (n == 928)
        return 65;
    else if (n == 935)
        return 66;
    else if (n == 942)
        return 67;
    else if (n == 949)
        return 68;
    else if (n == 956)
        return 69;
    else if (n == 963)
        return 70;
    else if (n == 970)
        return 71;
    else if (n == 977)
        return 72;
    else if (n == 984)
        return 73;
    else if (n == 991)
        return 74;
    else if (n == 998)
        return 75;
    else if (n == 1005)
        return 76;
    else if (n == 3)
        return 77;
    else if (n == 10)
        return 78;
    else if (n == 17)
        return 79;
    else if (n == 24)
        return 80;
    else if (n == 31)
        return 81;
    else if (n == 38)
        return 82;
    else if (n == 45)
        return 83;
    else if (n == 52)
        return 84;
    else if (n == 59)
        return 85;
    else if (n == 66)
        return 86;
    else if (n == 73)
        return 87;
    else if (n == 80)
        return 88;
    else if (n == 87)
        return 89;
    else if (n == 94)
        return 90;
    else if (n == 101)
        return 91;
    else if (n == 108)
        return 92;
    else if (n == 115)
        return 93;
    else if (n == 122)
        return 94;
    else if (n == 129)
        return 95;
    else if (n == 136)
        return 96;
    else if (n == 143)
        return 97;
    else if (n == 150)
        return 98;
    else if (n == 157)
        return 99;
    else if (n == 164)
        return 0;
    else if (n == 171)
        return 1;
    else if (n == 178)
        return 2;
    else if (n == 185)
        return 3;
    else if (n == 192)
        return 4;
    else if (n == 199)
        return 5;
    else if (n == 206)
        return 6;
    else if (n == 213)
        return 7;
    else if (n == 220)
        return 8;
    else if (n == 227)
        return 9;
    else if (n == 234)
        return 10;
    else if (n == 241)
        return 11;
    else if (n == 248)
        return 12;
    else if (n == 255)
        return 13;
    else if (n == 262)
        return 14;
    else if (n == 269)
        return 15;
    else if (n == 276)
        return 16;
    else if (n == 283)
        return 17;
    else if (n == 290)
        return 18;
    else if (n == 297)
        return 19;
    else if (n == 304)
        return 20;
    else if (n == 311)
        return 21;
    else if (n == 318)
        return 22;
    else if (n == 325)
        return 23;
    else if (n == 332)
        return 24;
    else if (n == 339)
        return 25;
    else if (n == 346)
        return 26;
    else if (n == 353)
        return 27;
    else if (n == 360)
        return 28;
    else if (n == 367)
        return 29;
    else if (n == 374)
        return 30;
    else if (n == 381)
        return 31;
    else if (n == 388)
        return 32;
    else if (n == 395)
        return 33;
    else if (n == 402)
        return 34;
    else if (n == 409)
        return 35;
    else if (n == 416)
        return 36;
    else if (n == 423)
        return 37;
    else if (n == 430)
        return 38;
    else if (n == 437)
        return 39;
    else if (n == 444)
        return 40;
    else if (n == 451)
        return 41;
    else if (n == 458)
        return 42;
    else if (n == 465)
        return 43;
    else if (n == 472)
        return 44;
    else if (n == 479)
        return 45;
    else if (n == 486)
        return 46;
    else if (n == 493)
        return 47;
    else if (n == 500)
        return 48;
    else if (n == 507)
        return 49;
    else if (n == 514)
        return 50;
    else if (n == 521)
        return 51;
    else if (n == 528)
        return 52;
    else if (n == 535)
        return 53;
    else if (n == 542)
        return 54;
    else if (n == 549)
        return 55;
    else if (n == 556)
        return 56;
    else if (n == 563)
        return 57;
    else if (n == 570)
        return 58;
    else if (n == 577)
        return 59;
    else if (n == 584)
        return 60;
    else if (n == 591)
        return 61;
    else if (n == 598)
        return 62;
    else if (n == 605)
        return 63;
    else if (n == 612)
        return 64;
    else if (n == 619)
        return 65;
    else if (n == 626)
        return 66;
    else if (n == 633)
        return 67;
    else if (n == 640)
        return 68;
    else if (n == 647)
        return 69;
    else if (n == 654)
        return 70;
    else if (n == 661)
        return 71;
    else if (n == 668)
        return 72;
    else if (n == 675)
        return 73;
    else if (n == 682)
        return 74;
    else if (n == 689)
        return 75;
    else if (n == 696)
        return 76;
    else if (n == 703)
        return 77;
    else if (n == 710)
        return 78;
    else if (n == 717)
        return 79;
    else if (n == 724)
        return 80;
    else if (n == 731)
        return 81;
    else if (n == 738)
        return 82;
    else if (n == 745)
        return 83;
    else if (n == 752)
        return 84;
    else if (n == 759)
        return 85;
    else if (n == 766)
        return 86;
    else if (n == 773)
        return 87;
    else if (n == 780)
        return 88;
    else if (n == 787)
        return 89;
    else if (n == 794)
        return 90;
    else if (n == 801)
        return 91;
    else if (n == 808)
        return 92;
    else if (n == 815)
        return 93;
    else if (n == 822)
        return 94;
    else if (n == 829)
        return 95;
    else if (n == 836)
        return 96;
    else if (n == 843)
        return 97;
    else if (n == 850)
        return 98;
    else if (n == 857)
        return 99;
    else if (n == 864)
        return 0;
    else if (n == 871)
        return 1;
    else if (n == 878)
        return 2;
    else if (n == 885)
        return 3;
    else if (n == 892)
        return 4;
    else if (n == 899)
        return 5;
    else if (n == 906)
        return 6;
    else if (n == 913)
        return 7;
    else if (n == 920)
        return 8;
    else if (n == 927)
        return 9;
    else if (n == 934)
        return 10;
    else if (n == 941)
        return 11;
    else if (n == 948)
        return 12;
    else if (n == 955)
        return 13;
    else if (n == 962)
        return 14;
    else if (n == 969)
        return 15;
    else if (n == 976)
        return 16;
    else if (n == 983)
        return 17;
    else if (n == 990)
        return 18;
    else if (n == 997)
        return 19;
    else if (n == 1004)
        return 20;
    else if (n == 2)
        return 21;
    else if (n == 9)
        return 22;
    else if (n == 16)
        return 23;
    else if (n == 23)
        return 24;
    else if (n == 30)
        return 25;
    else if (n == 37)
        return 26;
    else if (n == 44)
        return 27;
    else if (n == 51)
        return 28;
    else if (n == 58)
        return 29;
    else if (n == 65)
        return 30;
    else if (n == 72)
        return 31;
    else if (n == 79)
        return 32;
    else if (n == 86)
        return 33;
    else if (n == 93)
        return 34;
    else if (n == 100)
        return 35;
    else if (n == 107)
        return 36;
    else if (n == 114)
        return 37;
    else if (n == 121)
        return 38;
    else if (n == 128)
        return 39;
    else if (n == 135)
        return 40;
    else if (n == 142)
        return 41;
    else if (n == 149)
        return 42;
    else if (n == 156)
        return 43;
    else if (n == 163)
        return 44;
    else if (n == 170)
        return 45;
    else if (n == 177)
        return 46;
    else if (n == 184)
        return 47;
    else if (n == 191)
        return 48;
    else if (n == 198)
        return 49;
    else if (n == 205)
        return 50;
    else if (n == 212)
        return 51;
    else if (n == 219)
        return 52;
    else if (n == 226)
        return 53;
    else if (n == 233)
        return 54;
    else if (n == 240)
        return 55;
    else if (n == 247)
        return 56;
    else if (n == 254)
        return 57;
    else if (n == 261)
        return 58;
    else if (n == 268)
        return 59;
    else if (n == 275)
        return 60;
    else if (n == 282)
        return 61;
    else if (n == 289)
        return 62;
    else if (n == 296)
        return 63;
    else if (n == 303)
        return 64;
    else if (n == 310)
        return 65;
    else if (n == 317)
        return 66;
    else if (n == 324)
        return 67;
    else if (n == 331)
        return 68;
    else if (n == 338)
        return 69;
    else if (n == 345)
        return 70;
    else if (n == 352)
        return 71;
    else if (n == 359)
        return 72;
    else if (n == 366)
        return 73;
    else if (n == 373)
        return 74;
    else if (n == 380)
        return 75;
    else if (n == 387)
        return 76;
    else if (n == 394)
        return 77;
    else if (n == 401)
        return 78;
    else if (n == 408)
        return 79;
    else if (n == 415)
        return 80;
    else if (n == 422)
        return 81;
    else if (n == 429)
        return 82;
    else if (n == 436)
        return 83;
    else if (n == 443)
        return 84;
    else if (n == 450)
        return 85;
    else if (n == 457)
        return 86;
    else if (n == 464)
        return 87;
    else if (n == 471)
        return 88;
    else if (n == 478)
        return 89;
    else if (n == 485)
        return 90;
    else if (n == 492)
        return 91;
    else if (n == 499)
        return 92;
    else if (n == 506)
        return 93;
    else if (n == 513)
        return 94;
    else if (n == 520)
        return 95;
    else if (n == 527)
        return 96;
    else if (n == 534)
        return 97;
    else if (n == 541)
        return 98;
    else if (n == 548)
        return 99;
    else if (n == 555)
        return 0;
    else if (n == 562)
        return 1;
    else if (n == 569)
        return 2;
    else if (n == 576)
        return 3;
    else if (n == 583)
        return 4;
    else if (n == 590)
        return 5;
    else if (n == 597)
        return 6;
    else if (n == 604)
        return 7;
    else if (n == 611)
        return 8;
    else if (n == 618)
        return 9;
    else if (n == 625)
        return 10;
    else if (n == 632)
        return 11;
    else if (n == 639)
        return 12;
    else if (n == 646)
        return 13;
    else if (n == 653)
        return 14;
    else if (n == 660)
        return 15;
    else if (n == 667)
        return 16;
    else if (n == 674)
        return 17;
    else if (n == 681)
        return 18;
    else if (n == 688)
        return 19;
    else if (n == 695)
        return 20;
    else if (n == 702)
        return 21;
    else if (n == 709)
        return 22;
    else if (n == 716)
        return 23;
    else if (n == 723)
        return 24;
    else if (n == 730)
        return 25;
    else if (n == 737)
        return 26;
    else if (n == 744)
        return 27;
    else if (n == 751)
        return 28;
    else if (n == 758)
        return 29;
    else if (n == 765)
        return 30;
    else if (n == 772)
        return 31;
    else if (n == 779)
        return 32;
    else if (n == 786)
        return 33;
    else if (n == 793)
        return 34;
    else if (n == 800)
        return 35;
    else if (n == 807)
        return 36;
    else if (n == 814)
        return 37;
    else if (n == 821)
        return 38;
    else if (n == 828)
        return 39;
    else if (n == 835)
        return 40;
    else if (n == 842)
        return 41;
    else if (n == 849)
        return 42;
    else if (n == 856)
        return 43;
    else if (n == 863)
        return 44;
    else if (n == 870)
        return 45;
    else if (n == 877)
        return 46;
    else if (n == 884)
        return 47;
    else if (n == 891)
        return 48;
    else if (n == 898)
        return 49;
    else if (n == 905)
        return 50;
    else if (n == 912)
        return 51;
    else if (n == 919)
        return 52;
    else if (n == 926)
        return 53;
    else if (n == 933)
        return 54;
    else if (n == 940)
        return 55;
    else if (n == 947)
        return 56;
    else if (n == 954)
        return 57;
    else if (n == 961)
        return 58;
    else if (n == 968)
        return 59;
    else if (n == 975)
        return 60;
    else if (n == 982)
        return 61;
    else if (n == 989)
        return 62;
    else if (n == 996)
        return 63;
    else if (n == 1003)
        return 64;
    else if (n == 1)
        return 65;
    else if (n == 8)
        return 66;
    else if (n == 15)
        return 67;
    else if (n == 22)
        return 68;
    else if (n == 29)
        return 69;
    else if (n == 36)
        return 70;
    else if (n == 43)
        return 71;
    else if (n == 50)
        return 72;
    else if (n == 57)
        return 73;
    else if (n == 64)
        return 74;
    else if (n == 71)
        return 75;
    else if (n == 78)
        return 76;
    else if (n == 85)
        return 77;
    else if (n == 92)
        return 78;
    else if (n == 99)
        return 79;
    else if (n == 106)
        return 80;
    else if (n == 113)
        return 81;
    else if (n == 120)
        return 82;
    else if (n == 127)
        return 83;
    else if (n == 134)
        return 84;
    else if (n == 141)
        return 85;
    else if (n == 148)
        return 86;
    else if (n == 155)
        return 87;
    else if (n == 162)
        return 88;
    else if (n == 169)
        return 89;
    else if (n == 176)
        return 90;
    else if (n == 183)
        return 91;
    else if (n == 190)
        return 92;
    else if (n == 197)
        return 93;
    else if (n == 204)
        return 94;
    else if (n == 211)
        return 95;
    else if (n == 218)
        return 96;
    else if (n == 225)
        return 97;
    else if (n == 232)
        return 98;
    else if (n == 239)
        return 99;
    else if (n == 246)
        return 0;
    else if (n == 253)
        return 1;
    else if (n == 260)
        return 2;
    else if (n == 267)
        return 3;
    else if (n == 274)
        return 4;
    else if (n == 281)
        return 5;
    else if (n == 288)
        return 6;
    else if (n == 295)
        return 7;
    else if (n == 302)
        return 8;
    else if (n == 309)
        return 9;
    else if (n == 316)
        return 10;
    else if (n == 323)
        return 11;
    else if (n == 330)
        return 12;
    else if (n == 337)
        return 13;
    else if (n == 344)
        return 14;
    else if (n == 351)
        return 15;
    else if (n == 358)
        return 16;
    else if (n == 365)
        return 17;
    else if (n == 372)
        return 18;
    else if (n == 379)
        return 19;
    else if (n == 386)
        return 20;
    else if (n == 393)
        return 21;
    else if (n == 400)
        return 22;
    else if (n == 407)
        return 23;
    else if (n == 414)
        return 24;
    else if (n == 421)
        return 25;
    else if (n == 428)
        return 26;
    else if (n == 435)
        return 27;
    else if (n == 442)
        return 28;
    else if (n == 449)
        return 29;
    else if (n == 456)
        return 30;
    else if (n == 463)
        return 31;
    else if (n == 470)
        return 32;
    else if (n == 477)
        return 33;
    else if (n == 484)
        return 34;
    else if (n == 491)
        return 35;
    else if (n == 498)
        return 36;
    else if (n == 505)
        return 37;
    else if (n == 512)
        return 38;
    else if (n == 519)
        return 39;
    else if (n == 526)
        return 40;
    else if (n == 533)
        return 41;
    else if (n == 540)
        return 42;
    else if (n == 547)
        return 43;
    else if (n == 554)
        return 44;
    else if (n == 561)
        return 45;
    else if (n == 568)
        return 46;
    else if (n == 575)
        return 47;
    else if (n == 582)
        return 48;
    else if (n == 589)
        return 49;
    else if (n == 596)
        return 50;
    else if (n == 603)
        return 51;
    else if (n == 610)
        return 52;
    else if (n == 617)
        return 53;
    else if (n == 624)
        return 54;
    else if (n == 631)
        return 55;
    else if (n == 638)
        return 56;
    else if (n == 645)
        return 57;
    else if (n == 652)
        return 58;
    else if (n == 659)
        return 59;
    else if (n == 666)
        return 60;
    else if (n == 673)
        return 61;
    else if (n == 680)
        return 62;
    else if (n == 687)
        return 63;
    else if (n == 694)
        return 64;
    else if (n == 701)
        return 65;
    else if (n == 708)
        return 66;
    else if (n == 715)
        return 67;
    else if (n == 722)
        return 68;
    else if (n == 729)
        return 69;
    else if (n == 736)
        return 70;
    else if (n == 743)
        return 71;
    else if (n == 750)
        return 72;
    else if (n == 757)
        return 73;
    else if (n == 764)
        return 74;
    else if (n == 771)
        return 75;
    else if (n == 778)
        return 76;
    else if (n == 785)
        return 77;
    else if (n == 792)
        return 78;
    else if (n == 799)
        return 79;
    else if (n == 806)
        return 80;
    else if (n == 813)
        return 81;
    else if (n == 820)
        return 82;
    else if (n == 827)
        return 83;
    else if (n == 834)
        return 84;
    else if (n == 841)
        return 85;
    else if (n == 848)
        return 86;
    else if (n == 855)
        return 87;
    else if (n == 862)
        return 88;
    else if (n == 869)
        return 89;
    else if (n == 876)
        return 90;
    else if (n == 883)
        return 91;
    else if (n == 890)
        return 92;
    else if (n == 897)
        return 93;
    else if (n == 904)
        return 94;
    else if (n == 911)
        return 95;
    else if (n == 918)
        return 96;
    else if (n == 925)
        return 97;
    else if (n == 932)
        return 98;
    else if (n == 939)
        return 99;
   
    return -1;
}

int main(void)
{
    printf("%d %d %d %d\n", choose(0), choose(6), choose(500), choose(1008 + 1009));
    return 0;
}
