/* Strings to integers (C17 7.22.1, 7.8.2). */
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdlib.h>

static int digit_of(int c)
{
    if (isdigit(c))
        return c - '0';
    return isalpha(c) ? (c | 32) - 'a' + 10 : 99;
}

/* Reads an integer whose absolute value is at most `most`, or `most` + 1 when it is negative and
   `is_signed`. Beyond that it returns the limit, with errno ERANGE. */
static unsigned long long read_integer(const char *text, char **end, int base,
                                       unsigned long long most, int is_signed)
{
    const char *at = text;
    unsigned long long value = 0;
    int negative, digit, overflow = 0;

    if (base < 0 || base == 1 || base > 36) {
        errno = EINVAL;
        return 0;
    }
    if (end != NULL)
        *end = (char *)text;
    while (isspace((unsigned char)*at))
        at++;
    negative = *at == '-';
    if (*at == '-' || *at == '+')
        at++;
    if ((base == 0 || base == 16) && *at == '0' && (at[1] | 32) == 'x' && digit_of(at[2]) < 16) {
        at += 2;
        base = 16;
    }
    if (base == 0)
        base = *at == '0' ? 8 : 10;
    if (digit_of(*at) >= base)
        return 0;
    most += is_signed && negative;
    for (; (digit = digit_of(*at)) < base; at++) {
        if (value > most / base || value * base > most - digit)
            overflow = 1;
        else
            value = value * base + digit;
    }
    if (end != NULL)
        *end = (char *)at;
    if (overflow) {
        errno = ERANGE;
        return is_signed && negative ? -most : most;
    }
    return negative ? -value : value;
}

long strtol(const char *text, char **end, int base)
{
    return read_integer(text, end, base, LONG_MAX, 1);
}

unsigned long strtoul(const char *text, char **end, int base)
{
    return read_integer(text, end, base, ULONG_MAX, 0);
}

long long strtoll(const char *text, char **end, int base)
{
    return read_integer(text, end, base, LLONG_MAX, 1);
}

unsigned long long strtoull(const char *text, char **end, int base)
{
    return read_integer(text, end, base, ULLONG_MAX, 0);
}

intmax_t strtoimax(const char *text, char **end, int base)
{
    return read_integer(text, end, base, INTMAX_MAX, 1);
}

uintmax_t strtoumax(const char *text, char **end, int base)
{
    return read_integer(text, end, base, UINTMAX_MAX, 0);
}

int atoi(const char *text)
{
    return strtol(text, NULL, 10);
}

long atol(const char *text)
{
    return strtol(text, NULL, 10);
}

long long atoll(const char *text)
{
    return read_integer(text, NULL, 10, LLONG_MAX, 1);
}
