/* Formatted output: fields, text and integers (C17 7.21.6.1p8). */
#include <errno.h>
#include <limits.h>
#include <stddef.h>
#include <string.h>

#include <crs/stream.h>
#include <crs/utf8.h>

#include "print.h"

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
    if (text < sink->text + size && sink->start < text + size)
        __crs_stop("overlapping copy", text);
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

/* Prints the first `size` bytes that `count` wide characters have in UTF-8. */
static void print_wide(struct __crs_sink *sink, struct __crs_conversion *conversion,
                       const wchar_t *text, int count, int size)
{
    char bytes[4];
    int i, after;

    conversion->flags &= ~ZERO;
    after = __crs_open_field(sink, conversion, "", 0, size);
    for (i = 0; i < count; i++)
        __crs_emit(sink, bytes, __crs_encode(bytes, text[i]));
    __crs_pad(sink, ' ', after);
}

/* The precision counts bytes, and no character is cut in two (C17 7.21.6.1p8). */
static void print_wide_string(struct __crs_sink *sink, struct __crs_conversion *conversion,
                              const wchar_t *text, int most_characters)
{
    int most = conversion->precision < 0 ? INT_MAX : conversion->precision;
    int count = 0, size = 0, length;
    char bytes[4];

    if (text == NULL) {
        print_string(sink, conversion, NULL);
        return;
    }
    for (; count < most_characters && size < most; count++, size += length) {
        if (text[count] == 0 && most_characters == INT_MAX)
            break;
        length = __crs_encode(bytes, text[count]);
        if (length < 0) {
            sink->failed = EILSEQ;
            return;
        }
        if (length > most - size)
            break;
    }
    print_wide(sink, conversion, text, count, size);
}

/* Prints an unsigned value; `prefix` is the sign of a signed one. */
static void print_integer(struct __crs_sink *sink, struct __crs_conversion *conversion,
                          unsigned long long value, const char *prefix)
{
    const char *figures = conversion->letter == 'X' ? "0123456789ABCDEF" : "0123456789abcdef";
    char digits[64], *first = digits + sizeof digits;
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
    if (conversion->letter == 'b' || conversion->letter == 'B') {
        base = 2;
        if (conversion->flags & ALTERNATE && value != 0)
            prefix = conversion->letter == 'B' ? "0B" : "0b";
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

void __crs_print_signed(struct __crs_sink *sink, struct __crs_conversion *conversion,
                        long long value)
{
    if (conversion->length == 'H')
        value = (signed char)value;
    if (conversion->length == 'h')
        value = (short)value;
    print_integer(sink, conversion, value < 0 ? 0ULL - value : (unsigned long long)value,
                  sign_of(conversion, value < 0));
}

void __crs_print_unsigned(struct __crs_sink *sink, struct __crs_conversion *conversion,
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

void __crs_print_word(struct __crs_sink *sink, struct __crs_conversion *conversion, int value)
{
    wchar_t wide = value;
    char c = value;

    switch (conversion->letter) {
    case 'c':
        print_text(sink, conversion, &c, 1);
        break;
    case 'C':
        conversion->precision = -1;
        print_wide_string(sink, conversion, &wide, 1);
        break;
    case 'd': case 'i':
        __crs_print_signed(sink, conversion, value);
        break;
    case 'p':
        print_pointer(sink, conversion, value);
        break;
    case 'S':
        print_wide_string(sink, conversion, (const wchar_t *)value, INT_MAX);
        break;
    case 's':
        print_string(sink, conversion, (const char *)value);
        break;
    default:
        __crs_print_unsigned(sink, conversion, (unsigned int)value);
    }
}
