/* Formatted output (C17 7.21.6.1): the format; print.c and print_double.c do the conversions.

   Extensions are POSIX's numbered arguments, %2$d, and Linux's %m, the text of errno. */
#include <errno.h>
#include <limits.h>
#include <string.h>

#include <crs/stream.h>

#include "print.h"

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

/* Reads a width or precision; returns -1 when it is too large. */
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

/* The arguments of a call. */
struct arguments {
    va_list rest;            /* those not yet used */
    va_list all;
    const char *format;      /* has the sizes of numbered ones */
    int error;               /* errno as it was when the call began */
};

/* Reads the number of an argument, "2$"; 0 if there is none. */
static const char *read_position(const char *at, int *position)
{
    const char *behind = read_number(at, position);

    if (behind > at && *behind == '$' && *position > 0)
        return behind + 1;
    *position = 0;
    return at;
}

static int is_wide(const struct __crs_conversion *conversion)
{
    return strchr("aAeEfFgG", conversion->letter) != NULL ||
           (conversion->length == 'q' && strchr("diouxXbB", conversion->letter) != NULL);
}

static const char *read_specification(const char *at, struct __crs_conversion *conversion);

/* Returns the size of a numbered argument, which is that of the conversion that names it. */
static int size_of(const char *format, int position)
{
    struct __crs_conversion conversion;

    while ((format = strchr(format, '%')) != NULL) {
        format = read_specification(format + 1, &conversion);
        if (conversion.position == position && is_wide(&conversion))
            return 8;
        format += *format != 0;
    }
    return 4;
}

/* Returns the list from which the argument of a number, or the next one for 0, can be taken. */
static va_list *find_argument(struct arguments *arguments, int position, va_list *numbered)
{
    int before;

    if (position == 0)
        return &arguments->rest;
    va_copy(*numbered, arguments->all);
    for (before = 1; before < position && before < 64; before++)
        if (size_of(arguments->format, before) == 8)
            va_arg(*numbered, long long);
        else
            va_arg(*numbered, int);
    return numbered;
}

/* Prints one conversion that takes an argument; every argument is 4 bytes or 8. */
static void print_argument(struct __crs_sink *sink, struct __crs_conversion *conversion,
                           va_list *arguments)
{
    if (!is_wide(conversion))
        __crs_print_word(sink, conversion, va_arg(*arguments, int));
    else if (strchr("aAeEfFgG", conversion->letter) != NULL)
        __crs_print_double(sink, conversion, va_arg(*arguments, double));
    else if (conversion->letter == 'd' || conversion->letter == 'i')
        __crs_print_signed(sink, conversion, va_arg(*arguments, long long));
    else
        __crs_print_unsigned(sink, conversion, va_arg(*arguments, unsigned long long));
}

/* Reads a specification after its percent sign; returns a pointer to its conversion letter. */
static const char *read_specification(const char *at, struct __crs_conversion *conversion)
{
    conversion->width_from = conversion->precision_from = -1;
    at = read_position(at, &conversion->position);
    at = read_flags(at, conversion);
    if (*at == '*')
        at = read_position(at + 1, &conversion->width_from);
    else
        at = read_number(at, &conversion->width);
    conversion->precision = -1;
    if (*at == '.' && at[1] == '*') {
        at = read_position(at + 2, &conversion->precision_from);
    } else if (*at == '.') {
        at = read_number(at + 1, &conversion->precision);
        if (conversion->precision < 0)
            conversion->width = -1;
    }
    return read_length(at, conversion);
}

/* Stores the number of characters printed so far. */
static void store_count(const struct __crs_sink *sink, int length, void *to)
{
    if (length == 'H')
        *(signed char *)to = sink->count;
    else if (length == 'h')
        *(short *)to = sink->count;
    else if (length == 'q')
        *(long long *)to = sink->count;
    else
        *(int *)to = sink->count;
}

static void take_width_and_precision(struct __crs_conversion *conversion,
                                     struct arguments *arguments)
{
    va_list numbered;

    if (conversion->width_from >= 0) {
        conversion->width =
            va_arg(*find_argument(arguments, conversion->width_from, &numbered), int);
        if (conversion->width < 0) {
            conversion->flags |= LEFT;
            conversion->width = -conversion->width;
        }
    }
    if (conversion->precision_from >= 0)
        conversion->precision =
            va_arg(*find_argument(arguments, conversion->precision_from, &numbered), int);
}

/* Prints the conversion specification after a percent sign; returns a pointer to its end. */
static const char *print_conversion(struct __crs_sink *sink, const char *format,
                                    struct arguments *arguments)
{
    struct __crs_conversion conversion;
    const char *at = read_specification(format, &conversion);
    va_list numbered;

    take_width_and_precision(&conversion, arguments);
    if (conversion.width < 0) {
        sink->failed = EOVERFLOW;
    } else if (*at == 0) {
        sink->failed = EINVAL;
    } else if (*at == '%') {
        __crs_emit(sink, "%", 1);
    } else if (*at == 'm') {
        conversion.letter = 's';
        __crs_print_word(sink, &conversion, (int)strerror(arguments->error));
    } else if (*at == 'n') {
        store_count(sink, conversion.length,
                    va_arg(*find_argument(arguments, conversion.position, &numbered), void *));
    } else if (strchr("diouxXbBcCsSpaAeEfFgG", *at) != NULL) {
        print_argument(sink, &conversion,
                       find_argument(arguments, conversion.position, &numbered));
    } else {
        __crs_emit(sink, format - 1, at + 1 - (format - 1));
    }
    return *at ? at + 1 : at;
}

static int print(struct __crs_sink *sink, const char *format, va_list list)
{
    struct arguments arguments;

    arguments.format = format;
    arguments.error = errno;
    va_copy(arguments.all, list);
    va_copy(arguments.rest, list);
    while (*format && !sink->failed) {
        const char *at = format;
        while (*at && *at != '%')
            at++;
        __crs_emit(sink, format, at - format);
        format = *at ? print_conversion(sink, at + 1, &arguments) : at;
    }
    va_end(arguments.rest);
    va_end(arguments.all);
    if (!sink->failed)
        return sink->count;
    errno = sink->failed;
    return -1;
}

int __crs_print_to_string(char *text, unsigned int room, const char *format, va_list arguments)
{
    struct __crs_sink sink = {NULL, text, text, room, 0, 0};
    int result = print(&sink, format, arguments);

    *sink.text = 0;
    return result;
}

int vfprintf(FILE *stream, const char *format, va_list arguments)
{
    struct __crs_sink sink = {stream, NULL, NULL, 0, 0, 0};
    int result = print(&sink, format, arguments);

    return __crs_settle(stream) < 0 ? -1 : result;
}

int vprintf(const char *format, va_list arguments)
{
    return vfprintf(stdout, format, arguments);
}

int vsprintf(char *text, const char *format, va_list arguments)
{
    return __crs_print_to_string(text, INT_MAX, format, arguments);
}

int vsnprintf(char *text, size_t size, const char *format, va_list arguments)
{
    char nothing[1];

    if (size == 0)
        return __crs_print_to_string(nothing, 0, format, arguments);
    return __crs_print_to_string(text, size - 1, format, arguments);
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
