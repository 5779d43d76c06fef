/* Formatted output of floating-point numbers: %f %e %g %a (C17 7.21.6.1p8). */
#include <errno.h>
#include <limits.h>

#include "decimal.h"
#include "print.h"

/* A number cut into the parts of its text. */
struct text {
    char sign[4];            /* sign and, for %a, 0x */
    int sign_size;
    int upper;
    int point;               /* digits of the decimal in front of the point */
    int fraction;            /* digits after it */
    int dot;                 /* 1 if there is a decimal point */
    char exponent[8];
    int exponent_size;
};

/* Writes an exponent of at least `least` digits: e+05. */
static void write_exponent(struct text *text, char letter, int exponent, int least)
{
    char digits[8], *at = text->exponent;
    int size = 0;

    *at++ = letter;
    *at++ = exponent < 0 ? '-' : '+';
    if (exponent < 0)
        exponent = -exponent;
    for (; exponent > 0 || size < least; exponent /= 10)
        digits[size++] = '0' + exponent % 10;
    while (size > 0)
        *at++ = digits[--size];
    text->exponent_size = at - text->exponent;
}

/* Prints the digits from `from` up to `to`; outside of those that are stored they are 0. */
static void print_digits(struct __crs_sink *sink, const struct __crs_decimal *decimal,
                         int from, int to)
{
    int end;

    if (from < 0) {
        end = to < 0 ? to : 0;
        __crs_pad(sink, '0', end - from);
        from = end;
    }
    end = to < decimal->count ? to : decimal->count;
    if (from < end) {
        __crs_emit(sink, decimal->digits + from, end - from);
        from = end;
    }
    __crs_pad(sink, '0', to - from);
}

static void print_number(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                         const struct text *text, const struct __crs_decimal *decimal)
{
    int whole = text->point > 0 ? text->point : 1;
    int after = __crs_open_field(sink, conversion, text->sign, text->sign_size,
                                 whole + text->dot + text->fraction + text->exponent_size);

    print_digits(sink, decimal, text->point > 0 ? 0 : -1, text->point > 0 ? text->point : 0);
    if (text->dot)
        __crs_emit(sink, ".", 1);
    print_digits(sink, decimal, text->point, text->point + text->fraction);
    __crs_emit(sink, text->exponent, text->exponent_size);
    __crs_pad(sink, ' ', after);
}

/* Chooses between the forms of %f and %e, as C17 7.21.6.1p8 says for %g; returns 1 for %e. */
static int shape_general(struct text *text, struct __crs_decimal *decimal, double value,
                         int precision, int alternate)
{
    int exponent;

    if (precision == 0)
        precision = 1;
    __crs_round_significant(decimal, value, precision);
    exponent = decimal->count == 0 ? 0 : decimal->point - 1;
    if (!alternate) {
        int shown = exponent < precision && exponent >= -4 ? exponent + 1 : 1;
        while (decimal->count > 0 && decimal->digits[decimal->count - 1] == '0')
            decimal->count--;
        text->fraction = decimal->count > shown ? decimal->count - shown : 0;
        return exponent >= precision || exponent < -4;
    }
    if (exponent >= precision || exponent < -4) {
        text->fraction = precision - 1;
        return 1;
    }
    text->fraction = precision - 1 - exponent;
    return 0;
}

static void print_decimal(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                          struct text *text, double value)
{
    struct __crs_decimal decimal;
    int precision = conversion->precision < 0 ? 6 : conversion->precision;
    int letter = conversion->letter | 32, scientific = letter == 'e';

    text->fraction = precision;
    if (letter == 'g') {
        scientific = shape_general(text, &decimal, value, precision,
                                   conversion->flags & ALTERNATE);
    } else if (scientific) {
        __crs_round_significant(&decimal, value, precision + 1);
    } else {
        __crs_round_fixed(&decimal, value, precision);
    }
    text->point = decimal.count == 0 ? 1 : decimal.point;
    if (scientific) {
        write_exponent(text, text->upper ? 'E' : 'e', text->point - 1, 2);
        text->point = 1;
    }
    text->dot = text->fraction > 0 || conversion->flags & ALTERNATE;
    print_number(sink, conversion, text, &decimal);
}

/* %a: the leading digit is 1, or 0 for zero and for numbers below 2^-1022. */
static void print_hexadecimal(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                              struct text *text, unsigned long long bits)
{
    const char *figures = text->upper ? "0123456789ABCDEF" : "0123456789abcdef";
    int exponent = bits >> 52 & 0x7ff, i;
    struct __crs_decimal digits;

    bits &= 0xfffffffffffffULL;
    if (exponent > 0)
        bits |= 1ULL << 52;
    else if (bits != 0)
        exponent = 1;
    else
        exponent = 1023;
    if (conversion->precision >= 0 && conversion->precision < 13) {
        int dropped = 4 * (13 - conversion->precision);
        unsigned long long half = 1ULL << (dropped - 1);
        unsigned long long odd = bits >> dropped & 1;
        bits = (bits + half - 1 + odd) >> dropped << dropped;
    }
    digits.count = 14;
    for (i = 14; i-- > 0; bits >>= 4)
        digits.digits[i] = figures[bits & 15];
    text->fraction = conversion->precision;
    if (conversion->precision < 0) {
        while (digits.count > 1 && digits.digits[digits.count - 1] == '0')
            digits.count--;
        text->fraction = digits.count - 1;
    }
    text->sign[text->sign_size++] = '0';
    text->sign[text->sign_size++] = text->upper ? 'X' : 'x';
    text->point = 1;
    text->dot = text->fraction > 0 || conversion->flags & ALTERNATE;
    write_exponent(text, text->upper ? 'P' : 'p', exponent - 1023, 1);
    print_number(sink, conversion, text, &digits);
}

static void print_special(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                          const struct text *text, const char *name)
{
    struct __crs_conversion spaced = *conversion;
    int after;

    spaced.flags &= ~ZERO;
    after = __crs_open_field(sink, &spaced, text->sign, text->sign_size, 3);
    __crs_emit(sink, name, 3);
    __crs_pad(sink, ' ', after);
}

void __crs_print_double(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                        double value)
{
    union { double value; unsigned long long bits; } number;
    struct text text;
    char sign = conversion->flags & PLUS ? '+' : conversion->flags & SPACE ? ' ' : 0;

    if (conversion->precision > INT_MAX - 400) {
        sink->failed = EOVERFLOW;
        return;
    }
    number.value = value;
    if (number.bits >> 63)
        sign = '-';
    text.sign[0] = sign;
    text.sign_size = sign != 0;
    text.upper = conversion->letter < 'a';
    text.exponent_size = 0;
    if (value != value)
        print_special(sink, conversion, &text, text.upper ? "NAN" : "nan");
    else if (value - value != 0)
        print_special(sink, conversion, &text, text.upper ? "INF" : "inf");
    else if ((conversion->letter | 32) == 'a')
        print_hexadecimal(sink, conversion, &text, number.bits);
    else
        print_decimal(sink, conversion, &text, value);
}
