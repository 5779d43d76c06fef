/* Formatted output (C17 7.21.6.1), but for floating-point numbers: those are in print_double.c.

   %n is refused: it writes nothing, and the call gives -1 with errno EINVAL. */
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "print.h"
#include <crs/stream.h>

void __crs_emit(struct __crs_sink *sink, const char *text, int size)
{
    if (size <= 0)
        return;
    if ((unsigned int)size > INT_MAX - sink->count) {
        sink->failed = EOVERFLOW;
        return;
    }
    sink->count += size;
    if (sink->stream != NULL) {
        if (__crs_append(sink->stream, text, size) < 0)
            sink->failed = errno;
        return;
    }
    if ((unsigned int)size > sink->room)
        size = sink->room;
    if (size == 0)
        return;
    __builtin_memcpy(sink->text, text, size);
    sink->text += size;
    sink->room -= size;
}

void __crs_pad(struct __crs_sink *sink, char c, int count)
{
    char run[32];

    if (count <= 0)
        return;
    __builtin_memset(run, c, sizeof run);
    for (; count > 32 && !sink->failed; count -= 32)
        __crs_emit(sink, run, 32);
    __crs_emit(sink, run, count);
}

int __crs_open_field(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                     const char *prefix, int prefix_size, int size)
{
    int padding = conversion->width - prefix_size - size;

    if (!(conversion->flags & (LEFT | ZERO)))
        __crs_pad(sink, ' ', padding);
    __crs_emit(sink, prefix, prefix_size);
    if ((conversion->flags & (LEFT | ZERO)) == ZERO)
        __crs_pad(sink, '0', padding);
    return conversion->flags & LEFT ? padding : 0;
}

static void print_text(struct __crs_sink *sink, struct __crs_conversion *conversion,
                       const char *text, int size)
{
    int after;

    conversion->flags &= ~ZERO;
    after = __crs_open_field(sink, conversion, "", 0, size);
    __crs_emit(sink, text, size);
    __crs_pad(sink, ' ', after);
}

static void print_string(struct __crs_sink *sink, struct __crs_conversion *conversion,
                         const char *text)
{
    int most = conversion->precision < 0 ? INT_MAX : conversion->precision;
    int size = 0;

    if (text == NULL)
        text = most >= 6 ? "(null)" : "";
    while (size < most && text[size])
        size++;
    print_text(sink, conversion, text, size);
}

/* Wide characters beyond ASCII have no form in the "C" locale: EILSEQ (C17 7.21.6.1p14). */
static void print_wide(struct __crs_sink *sink, struct __crs_conversion *conversion,
                       const wchar_t *text, int size)
{
    int i, after;

    for (i = 0; i < size; i++)
        if (text[i] < 0 || text[i] > 127) {
            sink->failed = EILSEQ;
            return;
        }
    conversion->flags &= ~ZERO;
    after = __crs_open_field(sink, conversion, "", 0, size);
    for (i = 0; i < size; i++) {
        char c = text[i];
        __crs_emit(sink, &c, 1);
    }
    __crs_pad(sink, ' ', after);
}

static void print_wide_string(struct __crs_sink *sink, struct __crs_conversion *conversion,
                              const wchar_t *text)
{
    int most = conversion->precision < 0 ? INT_MAX : conversion->precision;
    int size = 0;

    if (text == NULL) {
        print_string(sink, conversion, NULL);
        return;
    }
    while (size < most && text[size])
        size++;
    print_wide(sink, conversion, text, size);
}

/* Prints an unsigned value; `prefix` is the sign of a signed one. */
static void print_integer(struct __crs_sink *sink, struct __crs_conversion *conversion,
                          unsigned long long value, const char *prefix)
{
    const char *figures = conversion->letter == 'X' ? "0123456789ABCDEF" : "0123456789abcdef";
    char digits[24], *first = digits + sizeof digits;
    int base = 10, size, zeros, after;
    unsigned int low;

    if (conversion->letter == 'o')
        base = 8;
    if ((conversion->letter | 32) == 'x') {
        base = 16;
        if (conversion->flags & ALTERNATE && value != 0)
            prefix = conversion->letter == 'X' ? "0X" : *prefix == '+' ? "+0x" :
                     *prefix == ' ' ? " 0x" : "0x";
    }
    for (; value > UINT_MAX; value /= base)
        *--first = figures[value % base];
    for (low = value; low > 0; low /= base)
        *--first = figures[low % base];

    size = digits + sizeof digits - first;
    zeros = (conversion->precision < 0 ? 1 : conversion->precision) - size;
    if (conversion->letter == 'o' && conversion->flags & ALTERNATE && zeros <= 0)
        zeros = 1;
    if (zeros < 0)
        zeros = 0;
    if (conversion->precision >= 0)
        conversion->flags &= ~ZERO;
    after = __crs_open_field(sink, conversion, prefix, strlen(prefix), size + zeros);
    __crs_pad(sink, '0', zeros);
    __crs_emit(sink, first, size);
    __crs_pad(sink, ' ', after);
}

static const char *sign_of(const struct __crs_conversion *conversion, int negative)
{
    if (negative)
        return "-";
    return conversion->flags & PLUS ? "+" : conversion->flags & SPACE ? " " : "";
}

static void print_signed(struct __crs_sink *sink, struct __crs_conversion *conversion,
                         long long value)
{
    if (conversion->length == 'H')
        value = (signed char)value;
    if (conversion->length == 'h')
        value = (short)value;
    print_integer(sink, conversion, value < 0 ? 0ULL - value : (unsigned long long)value,
                  sign_of(conversion, value < 0));
}

static void print_unsigned(struct __crs_sink *sink, struct __crs_conversion *conversion,
                           unsigned long long value)
{
    if (conversion->length == 'H')
        value = (unsigned char)value;
    if (conversion->length == 'h')
        value = (unsigned short)value;
    print_integer(sink, conversion, value, "");
}

static void print_pointer(struct __crs_sink *sink, struct __crs_conversion *conversion,
                          unsigned int value)
{
    conversion->letter = 'x';
    conversion->flags |= ALTERNATE;
    if (value != 0) {
        print_integer(sink, conversion, value, sign_of(conversion, 0));
        return;
    }
    print_text(sink, conversion, "(nil)", 5);
}

static const char *read_flags(const char *at, struct __crs_conversion *conversion)
{
    static const char flags[] = "-+ #0'";
    const char *flag;

    conversion->flags = 0;
    while (*at && (flag = strchr(flags, *at)) != NULL) {
        conversion->flags |= 1 << (flag - flags);
        at++;
    }
    return at;
}

/* Reads a width or precision; gives -1 when it is too large. */
static const char *read_number(const char *at, int *number)
{
    for (*number = 0; *at >= '0' && *at <= '9'; at++) {
        int digit = *at - '0';
        *number = *number < 0 || *number > (INT_MAX - digit) / 10 ? -1 : *number * 10 + digit;
    }
    return at;
}

static const char *read_length(const char *at, struct __crs_conversion *conversion)
{
    conversion->length = 0;
    if (*at && strchr("hlqLjzt", *at) != NULL) {
        conversion->length = *at++;
        if (conversion->length == *at && (*at == 'h' || *at == 'l'))
            conversion->length = *at++ == 'h' ? 'H' : 'q';
        if (conversion->length == 'L' || conversion->length == 'j')
            conversion->length = 'q';
    }
    conversion->letter = *at;
    if (conversion->length == 'l' && (*at == 's' || *at == 'c'))
        conversion->letter = *at == 's' ? 'S' : 'C';
    return at;
}

/* Prints an argument of integer type or a pointer. */
static void print_word(struct __crs_sink *sink, struct __crs_conversion *conversion, int value)
{
    wchar_t wide = value;
    char c = value;

    switch (conversion->letter) {
    case 'c':
        print_text(sink, conversion, &c, 1);
        break;
    case 'C':
        print_wide(sink, conversion, &wide, 1);
        break;
    case 'd': case 'i':
        print_signed(sink, conversion, value);
        break;
    case 'p':
        print_pointer(sink, conversion, value);
        break;
    case 'S':
        print_wide_string(sink, conversion, (const wchar_t *)value);
        break;
    case 's':
        print_string(sink, conversion, (const char *)value);
        break;
    case 'n':
        sink->failed = EINVAL;
        break;
    default:
        print_unsigned(sink, conversion, (unsigned int)value);
    }
}

/* Prints one conversion that takes an argument; every argument is 4 bytes or 8. */
static void print_argument(struct __crs_sink *sink, struct __crs_conversion *conversion,
                           va_list *arguments)
{
    if (strchr("aAeEfFgG", conversion->letter) != NULL) {
        __crs_print_double(sink, conversion, va_arg(*arguments, double));
    } else if (conversion->length == 'q' && strchr("diouxX", conversion->letter) != NULL) {
        if (conversion->letter == 'd' || conversion->letter == 'i')
            print_signed(sink, conversion, va_arg(*arguments, long long));
        else
            print_unsigned(sink, conversion, va_arg(*arguments, unsigned long long));
    } else {
        print_word(sink, conversion, va_arg(*arguments, int));
    }
}

/* Prints the conversion specification that begins behind a percent sign; gives what follows it. */
static const char *print_conversion(struct __crs_sink *sink, const char *format,
                                    va_list *arguments)
{
    struct __crs_conversion conversion;
    const char *at = read_flags(format, &conversion);

    if (*at == '*') {
        at++;
        conversion.width = va_arg(*arguments, int);
        if (conversion.width < 0) {
            conversion.flags |= LEFT;
            conversion.width = -conversion.width;
        }
    } else {
        at = read_number(at, &conversion.width);
    }
    conversion.precision = -1;
    if (*at == '.' && at[1] == '*') {
        at += 2;
        conversion.precision = va_arg(*arguments, int);
    } else if (*at == '.') {
        at = read_number(at + 1, &conversion.precision);
        if (conversion.precision < 0)
            conversion.width = -1;
    }
    at = read_length(at, &conversion);

    if (conversion.width < 0)
        sink->failed = EOVERFLOW;
    else if (*at == 0)
        sink->failed = EINVAL;
    else if (*at == '%')
        __crs_emit(sink, "%", 1);
    else if (strchr("diouxXcCsSpnaAeEfFgG", *at) != NULL)
        print_argument(sink, &conversion, arguments);
    else
        __crs_emit(sink, format - 1, at + 1 - (format - 1));
    return *at ? at + 1 : at;
}

static int print(struct __crs_sink *sink, const char *format, va_list arguments)
{
    va_list rest;

    va_copy(rest, arguments);
    while (*format && !sink->failed) {
        const char *at = format;
        while (*at && *at != '%')
            at++;
        __crs_emit(sink, format, at - format);
        format = *at ? print_conversion(sink, at + 1, &rest) : at;
    }
    va_end(rest);
    if (!sink->failed)
        return sink->count;
    errno = sink->failed;
    return -1;
}

static int print_to_string(char *text, unsigned int room, const char *format, va_list arguments)
{
    struct __crs_sink sink = {NULL, text, room, 0, 0};
    int result = print(&sink, format, arguments);

    *sink.text = 0;
    return result;
}

int vfprintf(FILE *stream, const char *format, va_list arguments)
{
    struct __crs_sink sink = {stream, NULL, 0, 0, 0};
    int result = print(&sink, format, arguments);

    return __crs_settle(stream) < 0 ? -1 : result;
}

int vprintf(const char *format, va_list arguments)
{
    return vfprintf(stdout, format, arguments);
}

int vsprintf(char *text, const char *format, va_list arguments)
{
    return print_to_string(text, INT_MAX, format, arguments);
}

int vsnprintf(char *text, size_t size, const char *format, va_list arguments)
{
    char nothing[1];

    if (size == 0)
        return print_to_string(nothing, 0, format, arguments);
    return print_to_string(text, size - 1, format, arguments);
}

int printf(const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vfprintf(stdout, format, arguments);
    va_end(arguments);
    return result;
}

int fprintf(FILE *stream, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vfprintf(stream, format, arguments);
    va_end(arguments);
    return result;
}

int sprintf(char *text, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vsprintf(text, format, arguments);
    va_end(arguments);
    return result;
}

int snprintf(char *text, size_t size, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vsnprintf(text, size, format, arguments);
    va_end(arguments);
    return result;
}
