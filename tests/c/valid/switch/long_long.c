/* switch on long long, labels converted to the controlling type. */
#include <stdio.h>

enum big { SMALL = 1 };

static int wide(long long n)
{
    switch (n) {
    case 1: return 1;
    case 0x100000001: return 2;
    case -1: return 3;
    case 0xFFFFFFFFu: return 4;
    case 1ll << 62: return 5;
    case SMALL + 1: return 6;
    default: return 0;
    }
}

static int uwide(unsigned long long n)
{
    switch (n & 0xF00000000) {
    case 0x100000000: return 1;
    case 0xF00000000: return 15;
    case 0: return 100;
    }
    return -1;
}

int main(void)
{
    printf("%d %d %d %d %d %d %d\n", wide(1), wide(4294967297ll), wide(-1), wide(4294967295ll),
           wide(4611686018427387904ll), wide(2), wide(3));
    printf("%d %d %d %d\n", uwide(0x1FFFFFFFFull), uwide(-1), uwide(77), uwide(1ull << 33));
    return 0;
}
