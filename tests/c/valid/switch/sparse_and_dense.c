/* Dense tables, sparse values, extremes of the range. */
#include <stdio.h>
#include <limits.h>

static int dense(unsigned n)
{
    switch (n) {
    case 10: return 1; case 11: return 1; case 12: return 2; case 13: return 3; case 14: return 5;
    case 15: return 8; case 16: return 13; case 17: return 21; case 18: return 34; case 20: return 89;
    }
    return 0;
}

static int sparse(int n)
{
    switch (n) {
    case INT_MIN: return 1;
    case -1000000: return 2;
    case -1: return 3;
    case 0: return 4;
    case 3: return 5;
    case 4096: return 6;
    case 1000000000: return 7;
    case INT_MAX: return 8;
    }
    return 0;
}

static int by_unsigned(unsigned n)
{
    switch (n) {
    case 0xFFFFFFFF: return 1;
    case 0x80000000: return 2;
    case 5: return 3;
    default: return 4;
    }
}

static int by_char(unsigned char c)
{
    switch (c) {
    case 255: return 1;
    case 128: return 2;
    case -1: return 3;
    }
    return 0;
}

int main(void)
{
    int values[] = { INT_MIN, -1000000, -1, 0, 3, 4096, 1000000000, INT_MAX, 1, -2, 4095 };
    unsigned i;

    for (i = 8; i < 23; i++)
        printf("%d ", dense(i));
    printf("%d\n", dense(-1));
    for (i = 0; i < sizeof values / sizeof *values; i++)
        printf("%d ", sparse(values[i]));
    printf("\n%d %d %d %d\n", by_unsigned(-1), by_unsigned(1u << 31), by_unsigned(5), by_unsigned(6));
    printf("%d %d %d\n", by_char(255), by_char((unsigned char) -128), by_char(1));
    return 0;
}
