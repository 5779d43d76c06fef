/* Random structs with bit-fields, attributes and #pragma pack: sizes, offsets, bytes. */
#include <stdio.h>
#include <stddef.h>
#include <string.h>
typedef int T0 __attribute__((aligned(8)));
typedef double T1 __attribute__((aligned(4)));
typedef short T2 __attribute__((aligned(1)));
typedef struct { char a; int b; } T3 __attribute__((aligned(8)));
struct s0 { signed char b0 : 5 __attribute__((packed, aligned(2))); int b1 : 21; float m2 __attribute__((aligned(2))); signed char b3 : 8 __attribute__((aligned(2))); short b5 : 3; int b6 : 3; } __attribute__((packed));
struct s0 g0 = { .b0 = 10, .b1 = 228455, .b3 = 87, .b5 = 1, .b6 = 3 };
#pragma pack(push, 8)
struct s1 { unsigned char b0 : 8 __attribute__((packed, aligned(2))); unsigned m1 __attribute__((packed, aligned(2))); _Bool b2 : 1; unsigned b3 : 16; long long m4; } __attribute__((packed));
#pragma pack(pop)
struct s1 g1 = { .b0 = 54, .b3 = 24380 };
struct s2 { long long b0 : 32 __attribute__((packed)); char m1[3] __attribute__((packed)); } __attribute__((packed, aligned(4)));
struct s2 g2 = { .b0 = 725298461 };
struct s3 { unsigned long long b0 : 19; signed char b1 : 2; unsigned long long m2[3]; } __attribute__((packed));
struct s3 g3 = { .b0 = 49610, .b1 = 1 };
struct s4 { short m0 __attribute__((aligned(16))); unsigned short m1[3]; unsigned short b2 : 2 __attribute__((aligned(8))); unsigned long long m3[3]; unsigned short b4 : 7; long long b5 : 56; };
struct s4 g4 = { .b2 = 1, .b4 = 61, .b5 = 23350556985574810 };
struct s5 { unsigned char m0[3]; short m1; unsigned char b2 : 6 __attribute__((packed)); int b3 : 25; unsigned long long b4 : 53; unsigned short b5 : 8; };
struct s5 g5 = { .b2 = 15, .b3 = 5871153, .b4 = 2736915085527530, .b5 = 2 };
struct s6 { unsigned short b0 : 13; unsigned long long b1 : 6; long long m2[3] __attribute__((__aligned__)); };
struct s6 g6 = { .b0 = 2579, .b1 = 14 };
struct s7 { unsigned char b0 : 3 __attribute__((aligned(2))); } __attribute__((packed));
struct s7 g7 = { .b0 = 2 };
int main(void)
{
  { struct s0 v; struct { char c; struct s0 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s0 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s0), (unsigned)offsetof(struct { char c; struct s0 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 5ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 7ull; v.b0 += 3; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  memset(&v, 0, sizeof v); v.b1 = 1188498ull; printf(" b1="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1); memset(&v, 255, sizeof v); v.b1 = 197661ull; v.b1 += 9; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1);
  printf(" m2@%u", (unsigned)offsetof(struct s0, m2));
  memset(&v, 0, sizeof v); v.b3 = 255ull; printf(" b3="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3); memset(&v, 255, sizeof v); v.b3 = 200ull; v.b3 += 7; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3);
  memset(&v, 0, sizeof v); v.b5 = 7ull; printf(" b5="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5); memset(&v, 255, sizeof v); v.b5 = 1ull; v.b5 += 12; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5);
  memset(&v, 0, sizeof v); v.b6 = 5ull; printf(" b6="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b6); memset(&v, 255, sizeof v); v.b6 = 7ull; v.b6 += 13; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b6);
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g0; i++) printf("%02x", ((unsigned char *)&g0)[i]); printf("\n"); }
  { struct s1 v; struct { char c; struct s1 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s1 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s1), (unsigned)offsetof(struct { char c; struct s1 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 180ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 114ull; v.b0 += 12; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  printf(" m1@%u", (unsigned)offsetof(struct s1, m1));
  memset(&v, 0, sizeof v); v.b2 = 1ull; printf(" b2="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2); memset(&v, 255, sizeof v); v.b2 = 0ull; v.b2 += 15; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2);
  memset(&v, 0, sizeof v); v.b3 = 37203ull; printf(" b3="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3); memset(&v, 255, sizeof v); v.b3 = 44021ull; v.b3 += 13; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3);
  printf(" m4@%u", (unsigned)offsetof(struct s1, m4));
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g1; i++) printf("%02x", ((unsigned char *)&g1)[i]); printf("\n"); }
  { struct s2 v; struct { char c; struct s2 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s2 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s2), (unsigned)offsetof(struct { char c; struct s2 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 2468924626ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 2315152300ull; v.b0 += 14; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  printf(" m1@%u", (unsigned)offsetof(struct s2, m1));
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g2; i++) printf("%02x", ((unsigned char *)&g2)[i]); printf("\n"); }
  { struct s3 v; struct { char c; struct s3 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s3 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s3), (unsigned)offsetof(struct { char c; struct s3 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 377640ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 482170ull; v.b0 += 0; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  memset(&v, 0, sizeof v); v.b1 = 3ull; printf(" b1="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1); memset(&v, 255, sizeof v); v.b1 = 2ull; v.b1 += 2; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1);
  printf(" m2@%u", (unsigned)offsetof(struct s3, m2));
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g3; i++) printf("%02x", ((unsigned char *)&g3)[i]); printf("\n"); }
  { struct s4 v; struct { char c; struct s4 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s4 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s4), (unsigned)offsetof(struct { char c; struct s4 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(struct s4, m0));
  printf(" m1@%u", (unsigned)offsetof(struct s4, m1));
  memset(&v, 0, sizeof v); v.b2 = 0ull; printf(" b2="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2); memset(&v, 255, sizeof v); v.b2 = 0ull; v.b2 += 9; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2);
  printf(" m3@%u", (unsigned)offsetof(struct s4, m3));
  memset(&v, 0, sizeof v); v.b4 = 60ull; printf(" b4="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b4); memset(&v, 255, sizeof v); v.b4 = 27ull; v.b4 += 10; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b4);
  memset(&v, 0, sizeof v); v.b5 = 56843337340950997ull; printf(" b5="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5); memset(&v, 255, sizeof v); v.b5 = 19757174873314830ull; v.b5 += 15; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5);
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g4; i++) printf("%02x", ((unsigned char *)&g4)[i]); printf("\n"); }
  { struct s5 v; struct { char c; struct s5 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s5 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s5), (unsigned)offsetof(struct { char c; struct s5 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(struct s5, m0));
  printf(" m1@%u", (unsigned)offsetof(struct s5, m1));
  memset(&v, 0, sizeof v); v.b2 = 53ull; printf(" b2="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2); memset(&v, 255, sizeof v); v.b2 = 2ull; v.b2 += 1; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2);
  memset(&v, 0, sizeof v); v.b3 = 4034628ull; printf(" b3="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3); memset(&v, 255, sizeof v); v.b3 = 18024212ull; v.b3 += 15; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3);
  memset(&v, 0, sizeof v); v.b4 = 8624595009618327ull; printf(" b4="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b4); memset(&v, 255, sizeof v); v.b4 = 392421942474800ull; v.b4 += 14; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b4);
  memset(&v, 0, sizeof v); v.b5 = 90ull; printf(" b5="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5); memset(&v, 255, sizeof v); v.b5 = 185ull; v.b5 += 1; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5);
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g5; i++) printf("%02x", ((unsigned char *)&g5)[i]); printf("\n"); }
  { struct s6 v; struct { char c; struct s6 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s6 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s6), (unsigned)offsetof(struct { char c; struct s6 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 5651ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 7247ull; v.b0 += 5; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  memset(&v, 0, sizeof v); v.b1 = 47ull; printf(" b1="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1); memset(&v, 255, sizeof v); v.b1 = 44ull; v.b1 += 7; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1);
  printf(" m2@%u", (unsigned)offsetof(struct s6, m2));
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g6; i++) printf("%02x", ((unsigned char *)&g6)[i]); printf("\n"); }
  { struct s7 v; struct { char c; struct s7 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s7 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s7), (unsigned)offsetof(struct { char c; struct s7 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 7ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 6ull; v.b0 += 6; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g7; i++) printf("%02x", ((unsigned char *)&g7)[i]); printf("\n"); }
  return 0;
}
