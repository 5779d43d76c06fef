/* Counting bits, and reversing bits and bytes. */
#include <stdio.h>

static const unsigned long long values[] = {
    1, 2, 3, 12, 0x80, 0xff00, 0x10000, 0x7fffffff, 0x80000000, 0xffffffff, 0x100000000,
    0x123456789abcdef0, 0x8000000000000000, ~0ull,
};

static int count;

static unsigned next(void)
{
    return 1u << count++;
}

int main(void)
{
    for (unsigned i = 0; i < sizeof values / sizeof *values; i++) {
        unsigned long long v = values[i];
        unsigned u = v;
        unsigned long l = v >> 3;
        if (u)
            printf("%d %d ", __builtin_clz(u), __builtin_ctz(u));
        if (l)
            printf("%d %d ", __builtin_clzl(l), __builtin_ctzl(l));
        printf("%d %d ", __builtin_clzll(v), __builtin_ctzll(v));
        printf("%d %d %d ", __builtin_popcount(u), __builtin_popcountl(l), __builtin_popcountll(v));
        printf("%d %d %d ", __builtin_parity(u), __builtin_parityl(l), __builtin_parityll(v));
        printf("%d %d %d ", __builtin_ffs(u), __builtin_ffsl(l), __builtin_ffsll(v));
        printf("%d %d %d ", __builtin_clrsb(u), __builtin_clrsbl(l), __builtin_clrsbll(v));
        printf("%x %x %llx\n", __builtin_bswap16(v), __builtin_bswap32(v), __builtin_bswap64(v));
    }
    printf("%d %d %d\n", __builtin_ffs(0), __builtin_ffsll(0), __builtin_popcount(0));
    printf("%d %d ", __builtin_ffs(next()), __builtin_parity(next()));
    printf("%x %d\n", __builtin_bswap32(next()), count);
    static const int table[] = {sizeof(__builtin_bswap16(1)), sizeof(__builtin_bswap64(1))};
    printf("%d %d\n", table[0], table[1]);
    return 0;
}
