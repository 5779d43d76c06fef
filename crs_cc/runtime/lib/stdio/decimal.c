/* The exact decimal value of a double, by arithmetic on integers of any length.

   A double is m * 2^e. Its integer part is written in base 2^32 and divided by 10^9 again and
   again, which gives nine digits each time, from the right. Its fraction is a binary fraction in
   base 2^32 and multiplied by 10^9 again and again; the integer part is the next nine digits,
   from the left, and the fraction is the exact remainder, so that the digits can end as soon as
   there are enough of them and rounding still knows whether it is below, on or above the middle. */
#include "decimal.h"

#define BLOCK 1000000000u
#define WORDS 35               /* 2^1024 has 33 words, 2^-1074 has 34 */

struct digits {
    struct __crs_decimal *to;
    unsigned int words[WORDS]; /* the remainder, least significant word first */
};

/* Appends nine digits; zeros in front of the first digit that counts only move the point. */
static void append_block(struct __crs_decimal *to, unsigned int block, int in_fraction)
{
    char nine[9];
    int i;

    for (i = 9; i-- > 0; block /= 10)
        nine[i] = '0' + block % 10;
    for (i = 0; i < 9; i++) {
        if (to->count > 0 || nine[i] != '0') {
            to->digits[to->count++] = nine[i];
            to->point += !in_fraction;
        } else {
            to->point -= in_fraction;
        }
    }
}

/* Appends the digits of the integer in the lowest `size` words. */
static void append_integer(struct digits *digits, int size)
{
    unsigned int blocks[WORDS];
    int count = 0, i;

    while (size > 0) {
        unsigned long long rest = 0;
        for (i = size; i-- > 0;) {
            rest = rest << 32 | digits->words[i];
            digits->words[i] = rest / BLOCK;
            rest %= BLOCK;
        }
        blocks[count++] = rest;
        while (size > 0 && digits->words[size - 1] == 0)
            size--;
    }
    while (count-- > 0)
        append_block(digits->to, blocks[count], 0);
}

/* Appends digits of the fraction in the lowest `size` words until `wanted` more are there than the
   point needs, or the fraction ends. Returns 1 when something is left. */
static int append_fraction(struct digits *digits, int size, int fixed, int precision)
{
    struct __crs_decimal *to = digits->to;
    int low = 0, i;

    for (;;) {
        unsigned long long carry = 0;
        while (low < size && digits->words[low] == 0)
            low++;
        if (low == size)
            return 0;
        if ((fixed ? to->count - to->point : to->count) > precision)
            return 1;
        for (i = low; i < size; i++) {
            carry += (unsigned long long)digits->words[i] * BLOCK;
            digits->words[i] = carry;
            carry >>= 32;
        }
        append_block(to, carry, 1);
    }
}

/* Cuts the digits at `keep` and rounds; `rest` is nonzero if more digits follow the last one. */
static void round_at(struct __crs_decimal *decimal, int keep, int rest)
{
    char *digits = decimal->digits;
    int i, up;

    if (keep >= decimal->count)
        return;
    if (keep < 0) {
        decimal->count = 0;
        return;
    }
    up = digits[keep] > '5';
    if (digits[keep] == '5') {
        up = rest || (keep > 0 && digits[keep - 1] % 2 != 0);
        for (i = keep + 1; i < decimal->count && !up; i++)
            up = digits[i] != '0';
    }
    decimal->count = keep;
    if (!up)
        return;
    while (decimal->count > 0 && digits[decimal->count - 1] == '9')
        decimal->count--;
    if (decimal->count > 0) {
        digits[decimal->count - 1]++;
    } else {
        digits[0] = '1';
        decimal->count = 1;
        decimal->point++;
    }
}

/* Stores m * 2^shift from the given word on; the words after it are cleared. */
static void store(struct digits *digits, unsigned long long m, int word, int shift)
{
    unsigned int *words = digits->words;

    __builtin_memset(words, 0, sizeof digits->words);
    words[word] = m << shift;
    m = shift == 0 ? m >> 32 : m >> (32 - shift);
    words[word + 1] = m;
    words[word + 2] = m >> 32;
}

static void convert(struct __crs_decimal *decimal, double x, int fixed, int precision)
{
    union { double value; unsigned long long bits; } number;
    struct digits digits;
    unsigned long long m;
    int e, rest = 0;

    decimal->count = decimal->point = 0;
    digits.to = decimal;
    number.value = x;
    m = number.bits & 0xfffffffffffffULL;
    e = number.bits >> 52 & 0x7ff;
    if (e > 0) {
        m |= 1ULL << 52;
        e--;
    }
    e -= 1074;
    if (m == 0)
        return;
    if (e >= 0) {
        store(&digits, m, e / 32, e % 32);
        append_integer(&digits, e / 32 + 3);
    } else {
        int size = (31 - e) / 32;
        if (e > -53 && m >> -e != 0) {
            store(&digits, m >> -e, 0, 0);
            append_integer(&digits, 3);
        }
        if (e > -64)
            m &= (1ULL << -e) - 1;
        store(&digits, m, 0, 32 * size + e);
        rest = append_fraction(&digits, size, fixed, precision);
    }
    round_at(decimal, fixed ? decimal->point + precision : precision, rest);
}

void __crs_round_fixed(struct __crs_decimal *decimal, double x, int precision)
{
    convert(decimal, x, 1, precision);
}

void __crs_round_significant(struct __crs_decimal *decimal, double x, int precision)
{
    convert(decimal, x, 0, precision);
}
