/* A floating constant that an integer type cannot hold becomes the nearest that it can. */
#include <stdio.h>

static unsigned below = -2.5;
static signed char above = 1000.0;
static const long long far[] = {1e30, -1e30, (unsigned)-1.0, (short)-70000.0};

int main(void)
{
    printf("%d %u %d %u\n", (int)2147483648.0f, (unsigned)-1.0, (int)-1e30, (unsigned)5e9);
    printf("%lld %llu %d\n", (long long)1e30, (unsigned long long)-3.5, (char)300.7);
    printf("%d %u %d\n", (int)__builtin_inf(), (unsigned)__builtin_nan(""), (_Bool)0.5);
    printf("%u %d %lld %lld %lld %lld\n", below, above, far[0], far[1], far[2], far[3]);
    return 0;
}
