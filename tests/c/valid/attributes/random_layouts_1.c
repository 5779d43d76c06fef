/* Random structs with bit-fields, attributes and #pragma pack: sizes, offsets, bytes. */
#include <stdio.h>
#include <stddef.h>
#include <string.h>
typedef int T0 __attribute__((aligned(8)));
typedef double T1 __attribute__((aligned(4)));
typedef short T2 __attribute__((aligned(1)));
typedef struct { char a; int b; } T3 __attribute__((aligned(8)));
union s0 { signed char b0 : 7; unsigned long long : 11; T0 m2; _Bool b3 : 1 __attribute__((aligned(2))); long long b4 : 30; T1 m5; };
struct s1 { unsigned long long m0[3]; unsigned char b1 : 8; signed char b2 : 8; signed char b3 : 5; double m4; float m5; T3 m6; } __attribute__((packed));
struct s1 g1 = { .b1 = 37, .b2 = 111, .b3 = 0 };
#pragma pack(push, 2)
struct s2 { long long m0; T3 m1; };
#pragma pack(pop)
struct s3 { T2 m0; } __attribute__((packed));
#pragma pack(push, 2)
union s4 { short m0; } __attribute__((packed));
#pragma pack(pop)
#pragma pack(push, 1)
struct s5 { char * m0; signed char b1 : 1; long long b2 : 55; double m3[3]; long long m4; unsigned long long b5 : 43 __attribute__((packed, aligned(2))); } __attribute__((packed));
#pragma pack(pop)
struct s5 g5 = { .b1 = 0, .b2 = 10649551514709483, .b5 = 524025793367 };
struct s6 { long long b0 : 16; _Bool b1 : 1; };
struct s6 g6 = { .b0 = 25679 };
struct s7 { int b0 : 25; T3 m1 __attribute__((__aligned__)); unsigned m2; } __attribute__((packed));
struct s7 g7 = { .b0 = 16725249 };
int main(void)
{
  { union s0 v; struct { char c; union s0 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s0 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(union s0), (unsigned)offsetof(struct { char c; union s0 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 47ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 25ull; v.b0 += 9; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  printf(" m2@%u", (unsigned)offsetof(union s0, m2));
  memset(&v, 0, sizeof v); v.b3 = 0ull; printf(" b3="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3); memset(&v, 255, sizeof v); v.b3 = 1ull; v.b3 += 11; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3);
  memset(&v, 0, sizeof v); v.b4 = 663937443ull; printf(" b4="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b4); memset(&v, 255, sizeof v); v.b4 = 547504870ull; v.b4 += 7; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b4);
  printf(" m5@%u", (unsigned)offsetof(union s0, m5));
  printf("\n"); }
  { struct s1 v; struct { char c; struct s1 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s1 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s1), (unsigned)offsetof(struct { char c; struct s1 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(struct s1, m0));
  memset(&v, 0, sizeof v); v.b1 = 191ull; printf(" b1="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1); memset(&v, 255, sizeof v); v.b1 = 227ull; v.b1 += 1; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1);
  memset(&v, 0, sizeof v); v.b2 = 45ull; printf(" b2="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2); memset(&v, 255, sizeof v); v.b2 = 113ull; v.b2 += 12; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2);
  memset(&v, 0, sizeof v); v.b3 = 1ull; printf(" b3="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3); memset(&v, 255, sizeof v); v.b3 = 10ull; v.b3 += 10; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b3);
  printf(" m4@%u", (unsigned)offsetof(struct s1, m4));
  printf(" m5@%u", (unsigned)offsetof(struct s1, m5));
  printf(" m6@%u", (unsigned)offsetof(struct s1, m6));
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g1; i++) printf("%02x", ((unsigned char *)&g1)[i]); printf("\n"); }
  { struct s2 v; struct { char c; struct s2 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s2 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s2), (unsigned)offsetof(struct { char c; struct s2 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(struct s2, m0));
  printf(" m1@%u", (unsigned)offsetof(struct s2, m1));
  printf("\n"); }
  { struct s3 v; struct { char c; struct s3 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s3 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s3), (unsigned)offsetof(struct { char c; struct s3 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(struct s3, m0));
  printf("\n"); }
  { union s4 v; struct { char c; union s4 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s4 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(union s4), (unsigned)offsetof(struct { char c; union s4 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(union s4, m0));
  printf("\n"); }
  { struct s5 v; struct { char c; struct s5 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s5 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s5), (unsigned)offsetof(struct { char c; struct s5 v; }, v));
  printf(" m0@%u", (unsigned)offsetof(struct s5, m0));
  memset(&v, 0, sizeof v); v.b1 = 0ull; printf(" b1="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1); memset(&v, 255, sizeof v); v.b1 = 0ull; v.b1 += 7; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1);
  memset(&v, 0, sizeof v); v.b2 = 15991682693050138ull; printf(" b2="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2); memset(&v, 255, sizeof v); v.b2 = 35258348154693857ull; v.b2 += 10; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b2);
  printf(" m3@%u", (unsigned)offsetof(struct s5, m3));
  printf(" m4@%u", (unsigned)offsetof(struct s5, m4));
  memset(&v, 0, sizeof v); v.b5 = 4808497466653ull; printf(" b5="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5); memset(&v, 255, sizeof v); v.b5 = 7669352647274ull; v.b5 += 12; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b5);
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g5; i++) printf("%02x", ((unsigned char *)&g5)[i]); printf("\n"); }
  { struct s6 v; struct { char c; struct s6 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s6 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s6), (unsigned)offsetof(struct { char c; struct s6 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 61219ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 9508ull; v.b0 += 8; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  memset(&v, 0, sizeof v); v.b1 = 0ull; printf(" b1="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1); memset(&v, 255, sizeof v); v.b1 = 1ull; v.b1 += 12; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b1);
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g6; i++) printf("%02x", ((unsigned char *)&g6)[i]); printf("\n"); }
  { struct s7 v; struct { char c; struct s7 v; } w; unsigned i; unsigned char *p = (unsigned char *)&v; (void)w;
 printf("s7 %u %u %u:", (unsigned)sizeof v, (unsigned)__alignof__(struct s7), (unsigned)offsetof(struct { char c; struct s7 v; }, v));
  memset(&v, 0, sizeof v); v.b0 = 9645512ull; printf(" b0="); for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0); memset(&v, 255, sizeof v); v.b0 = 22542068ull; v.b0 += 9; for (i = 0; i < sizeof v; i++) printf("%02x", p[i]); printf("=%lld", (long long)v.b0);
  printf(" m1@%u", (unsigned)offsetof(struct s7, m1));
  printf(" m2@%u", (unsigned)offsetof(struct s7, m2));
  printf("\n"); }
  { unsigned i; for (i = 0; i < sizeof g7; i++) printf("%02x", ((unsigned char *)&g7)[i]); printf("\n"); }
  return 0;
}
