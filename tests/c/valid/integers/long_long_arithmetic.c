/* 64-bit arithmetic on a 32-bit machine, mixed signs and large operands. */
#include <stdio.h>
#include <limits.h>

static void show(long long a, long long b)
{
    printf("%lld %lld: %lld %lld %lld", a, b, a + b, a - b, (long long) ((unsigned long long) a * b));
    if (b)
        printf(" %lld %lld", a / b, a % b);
    printf("\n");
}

static void ushow(unsigned long long a, unsigned long long b)
{
    printf("%llu %llu: %llu %llu %llu %llu %llu\n", a, b, a + b, a - b, a * b, a / b, a % b);
}

int main(void)
{
    show(7, 2);
    show(-7, 2);
    show(7, -2);
    show(-7, -2);
    show(123456789012345ll, 987654321ll);
    show(-123456789012345ll, 987654321ll);
    show(4294967296ll, -4294967295ll);
    show(4611686018427387904ll, 3);
    show(1, LLONG_MAX / 2);
    show(-4611686018427387904ll, 1000003);
    ushow(18446744073709551615ull, 10);
    ushow(18446744073709551615ull, 4294967296ull);
    ushow(9223372036854775808ull, 4294967295ull);
    ushow(1ull << 63, 3);
    ushow(5, 18446744073709551615ull);
    printf("%lld %lld\n", LLONG_MIN / 2, LLONG_MIN % 1000);
    printf("%lld\n", -LLONG_MAX);
    return 0;
}
