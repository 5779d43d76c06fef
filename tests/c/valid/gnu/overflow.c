/* Overflow-checking arithmetic, for all pairs of types, at the limits of their ranges. */
#include <limits.h>
#include <stdio.h>

static const long long edges[] = {
    0, 1, -1, 2, -2, 7, 100, 127, 128, -128, -129, 255, 256, 32767, -32768, 65535, 46341, INT_MAX,
    INT_MIN, (long long)INT_MAX + 1, UINT_MAX, (long long)UINT_MAX + 1, 3037000500, LLONG_MAX,
    LLONG_MIN, LLONG_MIN + 1,
};
#define COUNT ((int)(sizeof edges / sizeof *edges))

static unsigned hash = 5381, overflows;

static void note(int overflow, long long result)
{
    overflows += overflow;
    hash = hash * 33 + overflow;
    hash = hash * 33 + (unsigned)result;
    hash = hash * 33 + (unsigned)(result >> 32);
}

#define TRY(a_type, b_type, r_type) do { \
    for (int i = 0; i < COUNT; i++) \
        for (int j = 0; j < COUNT; j++) { \
            a_type a = edges[i]; \
            b_type b = edges[j]; \
            r_type r; \
            int o; \
            o = __builtin_add_overflow(a, b, &r); \
            note(o, r); \
            o = __builtin_sub_overflow(a, b, &r); \
            note(o, r); \
            o = __builtin_mul_overflow(a, b, &r); \
            note(o, r); \
            note(__builtin_mul_overflow_p(a, b, (r_type)0), 0); \
        } \
    printf("%s %s %s: %u %08x\n", #a_type, #b_type, #r_type, overflows, hash); \
} while (0)

static int evaluations;

static int *once(int *p)
{
    evaluations++;
    return p;
}

int main(void)
{
    int sum = 0, steps = 0;
    unsigned factorial = 1;
    long long power = 1;
    unsigned long large;

    TRY(int, int, int);
    TRY(int, int, unsigned);
    TRY(unsigned, int, int);
    TRY(unsigned, unsigned, unsigned);
    TRY(unsigned, unsigned, short);
    TRY(signed char, unsigned short, unsigned char);
    TRY(long, int, long long);
    TRY(long long, long long, long long);
    TRY(unsigned long long, long long, long long);
    TRY(unsigned long long, unsigned long long, unsigned long long);
    TRY(long long, unsigned, int);
    TRY(unsigned long long, signed char, unsigned short);
    while (!__builtin_sadd_overflow(sum, 100000007, &sum))
        steps++;
    printf("%d %d\n", steps, sum);
    for (steps = 1; !__builtin_umul_overflow(factorial, steps, &factorial); steps++)
        ;
    printf("%d %u\n", steps, factorial);
    for (steps = 0; !__builtin_smulll_overflow(power, 7, &power); steps++)
        ;
    printf("%d %lld\n", steps, power);
    printf("%d ", __builtin_usubl_overflow(3, 4, &large));
    printf("%lu %d ", large, __builtin_add_overflow(evaluations, 5, once(&sum)));
    printf("%d %d\n", evaluations, sum);
    if (__builtin_mul_overflow(sum, INT_MAX, &sum) && !__builtin_ssub_overflow(sum, 1, &sum))
        printf("%d\n", sum);
    return 0;
}
