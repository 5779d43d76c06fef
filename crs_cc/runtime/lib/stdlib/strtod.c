/* Strings to floating-point numbers, correctly rounded (C17 7.22.1.3).

   A decimal number D * 10^E with few digits is one exact multiplication or division (Clinger, "How
   to Read Floating Point Numbers Accurately", 1990). Any other is made an integer of any length:
   D * 5^E, or, for a negative E, D * 2^s / 5^-E with s such that the quotient has more than 64
   bits; dividing by small factors one after the other gives the same quotient, and any remainder
   shows that the number is not exact. The upper 64 bits, and whether any bit below them is set,
   are then rounded once, to the format's 53 or 24 bits or, below its normal range, to fewer. */
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>

#define MOST_DIGITS 800        /* the middle between two doubles has up to 767 digits */
#define WORDS 92               /* 800 digits, or 65 bits after 5^1130 */
#define FIVE_13 1220703125u

struct format { int bits, least_exponent, most_exponent; };

static const struct format double_format = {53, -1074, 1024}, float_format = {24, -149, 128};

struct big {
    int size;
    int inexact;               /* something smaller than 1 was lost */
    unsigned int words[WORDS]; /* least significant first, the last one not 0 */
};

/* A parsed number: the digits as an integer, and the power of ten that multiplies them. */
struct decimal {
    int digits, exponent;
    unsigned long long small;  /* the digits if there are at most 19 */
    struct big big;
};

static double scale(double value, int exponent)
{
    union { unsigned long long bits; double value; } power;

    for (; exponent < -1000; exponent += 1000)
        value *= 0x1p-1000;
    for (; exponent > 1000; exponent -= 1000)
        value *= 0x1p1000;
    power.bits = (unsigned long long)(exponent + 1023) << 52;
    return value * power.value;
}

/* Rounds m * 2^exponent, and a little more when `inexact`, to the nearest number, ties to even. */
static double round_to(const struct format *format, unsigned long long m, int exponent, int inexact)
{
    unsigned long long kept, rest, half;
    int drop = 64 - format->bits, zeros;

    if (m == 0)
        return 0;
    zeros = __builtin_clzll(m);
    m <<= zeros;
    exponent -= zeros;
    if (exponent + 64 > format->most_exponent)
        goto too_large;
    if (exponent + drop < format->least_exponent)
        drop = format->least_exponent - exponent;
    if (drop > 64) {
        errno = ERANGE;
        return 0;
    }
    half = 1ULL << (drop - 1);
    kept = m >> (drop - 1) >> 1;
    rest = m - (kept << (drop - 1) << 1);
    if (rest > half || (rest == half && (inexact || kept & 1)))
        kept++;
    if (kept == 1ULL << format->bits && exponent + 64 == format->most_exponent)
        goto too_large;
    if ((rest != 0 || inexact) && kept < 1ULL << (format->bits - 1))
        errno = ERANGE;
    return scale((double)kept, exponent + drop);
too_large:
    errno = ERANGE;
    return __builtin_huge_val();
}

static void multiply(struct big *big, unsigned int factor, unsigned int carry_in)
{
    unsigned long long carry = carry_in;
    int i;

    for (i = 0; i < big->size; i++) {
        carry += (unsigned long long)big->words[i] * factor;
        big->words[i] = carry;
        carry >>= 32;
    }
    if (carry != 0)
        big->words[big->size++] = carry;
}

static void divide(struct big *big, unsigned int divisor)
{
    unsigned long long rest = 0;
    int i;

    for (i = big->size; i-- > 0;) {
        rest = rest << 32 | big->words[i];
        big->words[i] = rest / divisor;
        rest %= divisor;
    }
    if (rest != 0)
        big->inexact = 1;
    while (big->size > 0 && big->words[big->size - 1] == 0)
        big->size--;
}

/* Puts zero words below the lowest one. */
static void shift_words(struct big *big, int words)
{
    __builtin_memmove(big->words + words, big->words, big->size * sizeof *big->words);
    __builtin_memset(big->words, 0, words * sizeof *big->words);
    big->size += words;
}

static unsigned int power_of_five(int exponent)
{
    unsigned int power = 1;

    while (exponent-- > 0)
        power *= 5;
    return power;
}

static double round_big(const struct format *format, const struct big *big, int exponent)
{
    unsigned long long m;
    int size = big->size, zeros, inexact = big->inexact, i;
    unsigned int low = size > 2 ? big->words[size - 3] : 0;

    m = (unsigned long long)big->words[size - 1] << 32;
    if (size > 1)
        m |= big->words[size - 2];
    zeros = __builtin_clzll(m);
    if (zeros > 0) {
        m = m << zeros | low >> (32 - zeros);
        low <<= zeros;
    }
    for (i = 0; i < size - 3 && low == 0; i++)
        low = big->words[i];
    return round_to(format, m, exponent + 32 * (size - 2) - zeros, inexact || low != 0);
}

static double convert_decimal(const struct format *format, struct decimal *decimal)
{
    static const double powers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21,
                                    1e22};
    struct big *big = &decimal->big;
    int exponent = decimal->exponent, words = 0, left;

    if (decimal->digits == 0)
        return 0;
    if (decimal->digits + exponent > 310)
        return round_to(format, 1, 2000, 0);
    if (decimal->digits + exponent < -330)
        return round_to(format, 1, -2000, 1);
    if (format->bits == 53 && decimal->digits <= 15 && exponent >= -22 && exponent <= 22)
        return exponent < 0 ? decimal->small / powers[-exponent]
                            : decimal->small * powers[exponent];
    if (exponent >= 0) {
        for (left = exponent; left >= 13; left -= 13)
            multiply(big, FIVE_13, 0);
        multiply(big, power_of_five(left), 0);
    } else {
        words = (65 - 32 * (big->size - 1) - exponent * 7 / 3) / 32 + 1;
        words = words < 0 ? 0 : words;
        shift_words(big, words);
        for (left = -exponent; left >= 13; left -= 13)
            divide(big, FIVE_13);
        divide(big, power_of_five(left));
    }
    return round_big(format, big, exponent - 32 * words);
}

/* Reads the exponent after an e or p, if one is there. */
static const char *read_exponent(const char *at, int *exponent)
{
    const char *digit = at + 1;
    int negative = *digit == '-', value = 0;

    if (*digit == '-' || *digit == '+')
        digit++;
    *exponent = 0;
    if (!isdigit(*digit))
        return at;
    for (; isdigit(*digit); digit++)
        if (value < 100000000)
            value = value * 10 + *digit - '0';
    *exponent = negative ? -value : value;
    return digit;
}

static void add_digit(struct decimal *decimal, int digit)
{
    if (decimal->digits == 0 && digit == 0)
        return;
    if (decimal->digits < MOST_DIGITS) {
        decimal->digits++;
        if (decimal->digits <= 19)
            decimal->small = decimal->small * 10 + digit;
        multiply(&decimal->big, 10, digit);
        return;
    }
    decimal->exponent++;
    if (digit != 0)
        decimal->big.inexact = 1;
}

/* Reads a decimal number; returns its end, or null if there is none. */
static const char *read_decimal(const char *at, const struct format *format, double *value)
{
    struct decimal decimal;
    int any = 0, exponent;

    decimal.digits = decimal.exponent = 0;
    decimal.small = 0;
    decimal.big.size = decimal.big.inexact = 0;
    for (; isdigit(*at); at++, any = 1)
        add_digit(&decimal, *at - '0');
    if (*at == '.') {
        for (at++; isdigit(*at); at++, any = 1) {
            add_digit(&decimal, *at - '0');
            decimal.exponent--;
        }
    }
    if (!any)
        return NULL;
    if ((*at | 32) == 'e') {
        at = read_exponent(at, &exponent);
        decimal.exponent += exponent;
    }
    *value = convert_decimal(format, &decimal);
    return at;
}

static int hexadecimal_digit(int c)
{
    return isdigit(c) ? c - '0' : (c | 32) - 'a' + 10;
}

/* Reads a hexadecimal number after its 0x; returns its end, or null if there is none. */
static const char *read_hexadecimal(const char *at, const struct format *format, double *value)
{
    unsigned long long m = 0;
    int exponent = 0, inexact = 0, any = 0, behind = 0, more;

    for (; isxdigit(*at) || (*at == '.' && !behind); at++) {
        if (*at == '.') {
            behind = 1;
            continue;
        }
        any = 1;
        if (m >> 60 == 0) {
            m = m << 4 | hexadecimal_digit(*at);
            exponent -= 4 * behind;
        } else {
            inexact |= *at != '0';
            exponent += 4 * !behind;
        }
    }
    if (!any)
        return NULL;
    if ((*at | 32) == 'p') {
        at = read_exponent(at, &more);
        exponent += more;
    }
    *value = round_to(format, m, exponent, inexact);
    return at;
}

/* Returns whether a text begins with a word of small letters, in either case. */
static int begins_with(const char *text, const char *word)
{
    for (; *word; text++, word++)
        if ((*text | 32) != *word)
            return 0;
    return 1;
}

static const char *read_special(const char *at, double *value)
{
    const char *end;

    if (begins_with(at, "inf")) {
        *value = __builtin_huge_val();
        return at + (begins_with(at, "infinity") ? 8 : 3);
    }
    if (!begins_with(at, "nan"))
        return NULL;
    *value = __builtin_nan("");
    at += 3;
    if (*at == '(') {
        for (end = at + 1; isalnum(*end) || *end == '_'; end++)
            ;
        if (*end == ')')
            return end + 1;
    }
    return at;
}

static double read_number(const char *text, char **end, const struct format *format)
{
    const char *at = text, *behind;
    double value = 0;
    int negative;

    while (isspace((unsigned char)*at))
        at++;
    negative = *at == '-';
    if (*at == '-' || *at == '+')
        at++;
    behind = isalpha(*at) ? read_special(at, &value) : NULL;
    if (behind == NULL && *at == '0' && (at[1] | 32) == 'x')
        behind = read_hexadecimal(at + 2, format, &value);
    if (behind == NULL)
        behind = read_decimal(at, format, &value);
    if (end != NULL)
        *end = (char *)(behind == NULL ? text : behind);
    return negative && behind != NULL ? -value : value;
}

double strtod(const char *text, char **end)
{
    return read_number(text, end, &double_format);
}

float strtof(const char *text, char **end)
{
    return (float)read_number(text, end, &float_format);
}

long double strtold(const char *text, char **end)
{
    return read_number(text, end, &double_format);
}

double atof(const char *text)
{
    return read_number(text, NULL, &double_format);
}
