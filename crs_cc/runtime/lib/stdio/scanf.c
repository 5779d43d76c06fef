/* Formatted input (C17 7.21.6.2): the format, white space and characters. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <crs/stream.h>

#include "scan.h"

static int skip_space(struct __crs_source *source)
{
    int c;

    while (isspace(c = __crs_next_input(source)))
        ;
    __crs_put_back(source, c);
    return c;
}

/* Where characters go: to the caller's array, to a block that grows, or nowhere. Of characters that
   shall be wide the UTF-8 is gathered in such a block first. */
struct text {
    char *bytes;
    int size, room;      /* room 0: unlimited */
    int counts;          /* characters, of which one may have several bytes */
};

/* Returns 0 if there is no memory. */
static int append(struct text *text, int c, int is_wide)
{
    char *larger;

    if (text->size + 1 == text->room) {
        larger = realloc(text->bytes, 2 * text->room);
        if (larger == NULL)
            return 0;
        text->bytes = larger;
        text->room *= 2;
    }
    if (text->bytes != NULL)
        text->bytes[text->size] = c;
    text->size++;
    text->counts += !is_wide || (c & 0xc0) != 0x80;
    return 1;
}

/* Reads up to `most` characters of a set; a set is the parsed text between [ and ]. */
static void scan_characters(struct __crs_source *source, int most, const char *member,
                            struct text *text, int is_wide)
{
    int missing = 0, c;    /* bytes that the last character lacks */

    while (text->counts < most || missing > 0) {
        c = __crs_next_input(source);
        if (c == EOF)
            break;
        if (!member[c] || !append(text, c, is_wide)) {
            __crs_put_back(source, c);
            break;
        }
        if (is_wide)
            missing = c < 0x80 ? 0 : c < 0xc0 ? missing - 1 : c < 0xe0 ? 1 : c < 0xf0 ? 2 : 3;
    }
}

/* Parses a scan set; returns a pointer after its bracket. A range may start with the end of the one
   before it, as in glibc: [a-b-z] has a to z, and [z-a] three characters. */
static const char *read_set(const char *at, char *member)
{
    int inside = *at != '^', from;
    const char *first;

    at += !inside;
    __builtin_memset(member, !inside, 256);
    first = at;
    do {
        if (*at == 0)
            return at;
        from = (unsigned char)*at++;
        if (from == '-' && at - first > 1 && *at != ']' && *at != 0 &&
            (unsigned char)at[-2] <= (unsigned char)*at)
            for (from = (unsigned char)at[-2]; from < (unsigned char)*at; from++)
                member[from] = inside;
        else
            member[from] = inside;
    } while (*at != ']');
    return at + 1;
}

/* Hands a gathered text over: as it is in a new block, or as wide characters. Returns 0 when that
   fails. */
static int hand_over(const struct __crs_input *conversion, struct text *text, int is_wide, int ends,
                     void *to)
{
    wchar_t *wide = to;
    int count;

    if (!is_wide) {
        *(char **)to = text->bytes;
        return 1;
    }
    text->bytes[text->size] = 0;
    if (conversion->allocates)
        wide = malloc((text->counts + 1) * sizeof *wide);
    count = wide == NULL ? -1 : (int)mbstowcs(wide, text->bytes, text->counts);
    if (count >= 0 && ends)
        wide[count] = 0;
    if (conversion->allocates)
        *(wchar_t **)to = wide;
    free(text->bytes);
    return count >= 0;
}

/* Converts %s, %[, and %c, whose input may end early, as on Linux. Returns 1 if something matched,
   and advances *format over a set. */
static int scan_string(struct __crs_source *source, const struct __crs_input *conversion,
                       int letter, const char **format, void *to)
{
    char member[256];
    struct text text = {to, 0, 0, 0};
    int most = conversion->width > 0 ? conversion->width : letter == 'c' ? 1 : 0x7fffffff;
    int is_wide = conversion->length == 'l', ends = letter != 'c', c;
    int gathers = to != NULL && (is_wide || conversion->allocates);

    if (letter == '[') {
        *format = read_set(*format, member);
    } else {
        for (c = 0; c < 256; c++)
            member[c] = letter == 'c' || !isspace(c);
    }
    if (gathers) {
        text.room = 32;
        text.bytes = malloc(text.room);
        if (text.bytes == NULL)
            return 0;
    }
    scan_characters(source, most, member, &text, is_wide);
    if (text.size == 0) {
        if (gathers)
            free(text.bytes);
        return 0;
    }
    if (to != NULL && ends && !is_wide)
        text.bytes[text.size] = 0;
    return gathers ? hand_over(conversion, &text, is_wide, ends, to) : 1;
}

/* Reads number, star, width and length of a conversion; returns the place of its letter. */
static const char *read_conversion(const char *at, struct __crs_input *conversion)
{
    const char *behind = at;

    for (conversion->position = 0; isdigit(*behind) && conversion->position < 100; behind++)
        conversion->position = conversion->position * 10 + *behind - '0';
    if (*behind == '$')
        at = behind + 1;
    else
        conversion->position = 0;
    conversion->suppressed = *at == '*';
    at += conversion->suppressed;
    conversion->width = conversion->length = 0;
    for (; isdigit(*at); at++)
        if (conversion->width < 100000000)
            conversion->width = conversion->width * 10 + *at - '0';
    conversion->allocates = *at == 'm';
    at += conversion->allocates;
    if (*at && strchr("hlqLjzt", *at) != NULL) {
        conversion->length = *at++;
        if (conversion->length == *at && (*at == 'h' || *at == 'l'))
            conversion->length = *at++ == 'h' ? 'H' : 'q';
        if (conversion->length == 'L' || conversion->length == 'j')
            conversion->length = 'q';
    }
    return at;
}

/* Does one conversion; returns 1 when it matched, 0 when not, EOF when the input ended before. */
static int scan_one(struct __crs_source *source, const struct __crs_input *conversion, int letter,
                    const char **format, void *to)
{
    int c;

    if (letter == 'n') {
        if (to != NULL)
            __crs_store_integer(to, conversion->length, source->count);
        return 1;
    }
    if (letter != 'c' && letter != '[') {
        c = skip_space(source);
    } else {
        c = __crs_next_input(source);
        __crs_put_back(source, c);
    }
    if (c == EOF)
        return EOF;
    switch (letter) {
    case 'd': case 'i': case 'b': case 'o': case 'u': case 'x': case 'X': case 'p':
        return __crs_scan_integer(source, conversion, letter, to);
    case 'a': case 'A': case 'e': case 'E': case 'f': case 'F': case 'g': case 'G':
        return __crs_scan_float(source, conversion, to);
    case 'c': case 's': case '[':
        return scan_string(source, conversion, letter, format, to);
    }
    return 0;
}

/* Matches white space or one ordinary character of the format; returns 1, 0 or EOF. */
static int match(struct __crs_source *source, int expected)
{
    int c;

    if (isspace(expected)) {
        skip_space(source);
        return 1;
    }
    c = __crs_next_input(source);
    if (c == expected)
        return 1;
    __crs_put_back(source, c);
    return c == EOF ? EOF : 0;
}

/* Returns the next argument, or the one of a number; all are pointers. */
static void *take_argument(va_list all, va_list *rest, int position)
{
    va_list numbered;
    void *found = NULL;

    if (position == 0)
        return va_arg(*rest, void *);
    va_copy(numbered, all);
    for (; position > 0; position--)
        found = va_arg(numbered, void *);
    va_end(numbered);
    return found;
}

static int scan(struct __crs_source *source, const char *format, va_list arguments)
{
    struct __crs_input conversion;
    int assigned = 0, result;
    va_list rest;

    va_copy(rest, arguments);
    while (*format) {
        if (*format == '%' && format[1] != '%') {
            void *to = NULL;
            int letter;
            format = read_conversion(format + 1, &conversion);
            letter = *format;
            if (letter == 'S' || letter == 'C') {
                conversion.length = 'l';
                letter |= 32;
            }
            format += letter != 0;
            if (!conversion.suppressed && letter != 0)
                to = take_argument(arguments, &rest, conversion.position);
            result = scan_one(source, &conversion, letter, &format, to);
            assigned += result > 0 && to != NULL && letter != 'n';
        } else {
            if (*format == '%') {
                skip_space(source);
                format++;
            }
            result = match(source, (unsigned char)*format++);
        }
        if (result <= 0) {
            va_end(rest);
            return result < 0 && assigned == 0 ? EOF : assigned;
        }
    }
    va_end(rest);
    return assigned;
}

int __crs_scan_stream(FILE *stream, const char *format, va_list arguments)
{
    struct __crs_source source = {stream, NULL, 0};

    return scan(&source, format, arguments);
}

int __crs_scan_string(const char *text, const char *format, va_list arguments)
{
    struct __crs_source source = {NULL, text, 0};

    return scan(&source, format, arguments);
}

int vfscanf(FILE *stream, const char *format, va_list arguments)
{
    return __crs_scan_stream(stream, format, arguments);
}

int vscanf(const char *format, va_list arguments)
{
    return __crs_scan_stream(stdin, format, arguments);
}

int vsscanf(const char *text, const char *format, va_list arguments)
{
    return __crs_scan_string(text, format, arguments);
}

int scanf(const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = __crs_scan_stream(stdin, format, arguments);
    va_end(arguments);
    return result;
}

int fscanf(FILE *stream, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = __crs_scan_stream(stream, format, arguments);
    va_end(arguments);
    return result;
}

int sscanf(const char *text, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = __crs_scan_string(text, format, arguments);
    va_end(arguments);
    return result;
}
