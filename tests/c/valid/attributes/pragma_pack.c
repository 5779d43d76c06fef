/* #pragma pack, as used in headers that describe file formats. */
#include <stdio.h>

struct before { char a; double b; };
#pragma pack(push, 1)
struct bytes { char a; double b; short c; };
#pragma pack(push, 2)
struct pairs { char a; double b; unsigned c : 30, d : 5; };
#pragma pack(pop)
struct again { char a; int b; };
_Pragma("pack(push, name, 4)") struct fours { char a; long long b; struct before c; };
#pragma pack(pop, name)
#pragma pack(pop)
struct after { char a; double b; };
#pragma pack(1)
union { char a; int b; } both;
#pragma pack()
struct last { char a; int b; };

int main(void)
{
    struct pairs p = {1, 2.0, 0x3fffffff, 3};
    printf("%u %u %u %u\n", (unsigned)sizeof(struct before), (unsigned)sizeof(struct bytes),
           (unsigned)sizeof(struct pairs), (unsigned)sizeof(struct again));
    printf("%u %u %u %u\n", (unsigned)sizeof(struct fours), (unsigned)sizeof(struct after),
           (unsigned)__alignof__(both), (unsigned)sizeof(struct last));
    printf("%u %u\n", p.c, p.d);
    return 0;
}
