/* Integer square root, gcd, power modulo and perfect numbers. */
#include <stdio.h>

static unsigned isqrt(unsigned n)
{
    unsigned root = 0, bit = 1u << 30;

    while (bit > n)
        bit >>= 2;
    while (bit) {
        if (n >= root + bit) {
            n -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
        bit >>= 2;
    }
    return root;
}

static long gcd(long a, long b)
{
    while (b) {
        long t = a % b;
        a = b;
        b = t;
    }
    return a < 0 ? -a : a;
}

static unsigned power_mod(unsigned base, unsigned exponent, unsigned modulus)
{
    unsigned long long result = 1, b = base % modulus;

    for (; exponent; exponent >>= 1) {
        if (exponent & 1)
            result = result * b % modulus;
        b = b * b % modulus;
    }
    return (unsigned) result;
}

int main(void)
{
    int n, d;

    for (n = 0; n < 20; n++)
        printf("%u ", isqrt(n * n * n));
    printf("\n%u %u\n", isqrt(4294967295u), isqrt(2147395600u));
    printf("%ld %ld %ld\n", gcd(1071, 462), gcd(-48, 18), gcd(17, 0));
    printf("%u %u\n", power_mod(2, 1000000006, 1000000007), power_mod(3, 12345, 4294967291u));
    for (n = 2; n < 500; n++) {
        int sum = 1;
        for (d = 2; d * d <= n; d++)
            if (n % d == 0)
                sum += d + (d * d != n ? n / d : 0);
        if (sum == n)
            printf("%d ", n);
    }
    printf("\n");
    return 0;
}
