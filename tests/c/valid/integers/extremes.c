/* Arithmetic at the ends of the ranges, as long as it stays inside. */
#include <limits.h>
#include <stdio.h>
#include <stdint.h>

int main(void)
{
    long long most = LLONG_MAX, least = LLONG_MIN;
    unsigned long long all = ULLONG_MAX;
    int i = INT_MIN;

    printf("%lld %lld %llu\n", most, least, all);
    printf("%lld %lld\n", most / 3, least / 3);
    printf("%lld %lld\n", most % 1000, least % 1000);
    printf("%lld %lld\n", least / most, least % most);
    printf("%llu %llu\n", all / 3, all % 7);
    printf("%d %d\n", i / 10, i % 10);
    printf("%d %d\n", i == -2147483647 - 1, i < -INT_MAX);
    printf("%lld\n", (long long) i * i);
    printf("%lld\n", (long long) INT_MAX * INT_MAX);
    printf("%llu\n", (unsigned long long) UINT_MAX * UINT_MAX);
    printf("%d %d\n", (int) (least >> 32), (int) (all >> 33));
    printf("%jd %ju\n", INTMAX_MIN, UINTMAX_MAX);
    printf("%lld\n", 1000000007ll * 998244353 % 1000000009);
    return 0;
}
