/* Alignment by attribute, of variables, members, structs and typedefs. */
#include <stddef.h>
#include <stdio.h>

typedef int wide __attribute__((aligned(8)));
typedef double narrow __attribute__((aligned(4)));
struct s { char a; short b __attribute__((aligned(4))); char c; } __attribute__((aligned(16)));
struct t { char a; wide b; char c; narrow d; };
struct u { char a; struct s b; int c __attribute__((packed, aligned(2))); };
struct v { char a; int b[2] __attribute__((__aligned__)); };
static char one, two __attribute__((aligned(32))), three;
__attribute__((aligned(64))) static int four[3];

#define SHOW(type) printf(#type " %u %u\n", (unsigned)sizeof(type), (unsigned)__alignof__(type))

int main(void)
{
    int local __attribute__((aligned(16))) = 1;
    static short kept __attribute__((aligned(128)));

    SHOW(struct s);
    SHOW(struct t);
    SHOW(struct u);
    SHOW(struct v);
    SHOW(wide);
    SHOW(narrow);
    printf("%u %u\n", (unsigned)offsetof(struct t, b), (unsigned)offsetof(struct t, d));
    printf("%u %u\n", (unsigned)offsetof(struct u, b), (unsigned)offsetof(struct u, c));
    printf("%u %u %u\n", (unsigned)&two % 32, (unsigned)four % 64, (unsigned)&local % 16);
    printf("%u %d\n", (unsigned)&kept % 128, one + three + local);
    printf("%u %u\n", (unsigned)__alignof__(two), (unsigned)__alignof__(four));
    return 0;
}
