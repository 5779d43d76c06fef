/* Formatted input (C17 7.21.6.2). A number of more than 511 characters ends there. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <crs/stream.h>

#define ROOM 512

/* Where the characters come from: a stream, or a string when `stream` is null. */
struct source {
    FILE *stream;
    const char *text;
    int count;           /* characters read so far */
};

struct conversion {
    int suppressed;      /* 1 when the value is not stored */
    int width;           /* 0 when absent */
    int length;          /* 'H' for hh, 'q' for ll, j and L, else the letter itself, or 0 */
};

/* An input item as it grows: at most `width` characters that fit its grammar. */
struct item {
    struct source *source;
    int width, size;
    char text[ROOM];
};

static int next(struct source *source)
{
    int c;

    if (source->stream != NULL)
        c = __crs_next(source->stream);
    else
        c = *source->text ? (unsigned char)*source->text++ : EOF;
    source->count += c != EOF;
    return c;
}

static void put_back(struct source *source, int c)
{
    if (c == EOF)
        return;
    source->count--;
    if (source->stream != NULL)
        ungetc(c, source->stream);
    else
        source->text--;
}

static int skip_space(struct source *source)
{
    int c;

    while (isspace(c = next(source)))
        ;
    put_back(source, c);
    return c;
}

/* Takes the next character into the item if it is one of the set; gives it, or 0. */
static int accept(struct item *item, const char *set)
{
    int c;

    if (item->size == item->width)
        return 0;
    c = next(item->source);
    if (c > 0 && strchr(set, c) != NULL)
        return item->text[item->size++] = c;
    put_back(item->source, c);
    return 0;
}

static int accept_all(struct item *item, const char *set)
{
    int size = item->size;

    while (accept(item, set))
        ;
    return item->size - size;
}

static void open_item(struct item *item, struct source *source, int width)
{
    item->source = source;
    item->size = 0;
    item->width = width > 0 && width < ROOM - 1 ? width : ROOM - 1;
}

static const char decimal_digits[] = "0123456789", hexadecimal_digits[] = "0123456789abcdefABCDEF";

/* Reads an integer; gives 0 when there is none. */
static int read_integer(struct item *item, int base, unsigned long long *value)
{
    const char *digits = decimal_digits;
    int any, negative;

    negative = accept(item, "+-") == '-';
    any = accept(item, "0");
    if (any && (base == 0 || base == 16) && accept(item, "xX")) {
        base = 16;
        any = 0;
    } else if (any && base == 0) {
        base = 8;
    }
    if (base == 16)
        digits = hexadecimal_digits;
    if (base == 8)
        digits = "01234567";
    if (!accept_all(item, digits) && !any)
        return 0;
    item->text[item->size] = 0;
    *value = negative ? (unsigned long long)strtoll(item->text, NULL, base)
                      : strtoull(item->text, NULL, base);
    return 1;
}

/* Takes letters as long as they spell the word, in either case. */
static int spells(struct item *item, const char *word)
{
    char either[3];

    for (; *word; word++) {
        either[0] = *word;
        either[1] = toupper(*word);
        either[2] = 0;
        if (!accept(item, either))
            return 0;
    }
    return 1;
}

/* Takes the characters of a floating-point number; gives 0 when they make none. */
static int read_float(struct item *item)
{
    const char *digits = decimal_digits, *exponent = "eE";
    int any, size;

    accept(item, "+-");
    size = item->size;
    if (spells(item, "nan"))
        return 1;
    if (item->size > size)
        return 0;
    if (spells(item, "inf")) {
        size = item->size;
        return spells(item, "inity") || item->size == size;
    }
    if (item->size > size)
        return 0;
    any = accept(item, "0");
    if (any && accept(item, "xX")) {
        digits = hexadecimal_digits;
        exponent = "pP";
        any = 0;
    }
    any |= accept_all(item, digits);
    if (accept(item, "."))
        any |= accept_all(item, digits);
    if (!any)
        return 0;
    if (accept(item, exponent)) {
        accept(item, "+-");
        return accept_all(item, decimal_digits);
    }
    return 1;
}

static void store_integer(void *to, int length, unsigned long long value)
{
    if (length == 'H')
        *(char *)to = value;
    else if (length == 'h')
        *(short *)to = value;
    else if (length == 'q')
        *(unsigned long long *)to = value;
    else
        *(int *)to = value;
}

static int scan_integer(struct source *source, const struct conversion *conversion, int letter,
                        void *to)
{
    struct item item;
    unsigned long long value;
    int base = letter == 'd' || letter == 'u' ? 10 : letter == 'i' ? 0 : letter == 'o' ? 8 : 16;

    open_item(&item, source, conversion->width);
    if (!read_integer(&item, base, &value))
        return 0;
    if (to != NULL)
        store_integer(to, conversion->length, value);
    return 1;
}

static int scan_float(struct source *source, const struct conversion *conversion, void *to)
{
    struct item item;

    open_item(&item, source, conversion->width);
    if (!read_float(&item))
        return 0;
    item.text[item.size] = 0;
    if (to == NULL)
        return 1;
    if (conversion->length == 'l' || conversion->length == 'q')
        *(double *)to = strtod(item.text, NULL);
    else
        *(float *)to = strtof(item.text, NULL);
    return 1;
}

/* Reads characters of a set; a set is what lies between [ and ], already taken apart. */
static int scan_characters(struct source *source, int most, const char *member, char *to)
{
    int size = 0, c;

    while (size < most && (c = next(source)) != EOF) {
        if (!member[c]) {
            put_back(source, c);
            break;
        }
        if (to != NULL)
            to[size] = c;
        size++;
    }
    return size;
}

/* Takes a scan set apart; gives what follows its bracket. */
static const char *read_set(const char *at, char *member)
{
    int inside = *at != '^', from, to;

    at += !inside;
    __builtin_memset(member, !inside, 256);
    do {
        if (*at == 0)
            return at;
        from = to = (unsigned char)*at++;
        if (*at == '-' && at[1] != ']' && at[1] != 0) {
            to = (unsigned char)at[1];
            at += 2;
        }
        for (; from <= to; from++)
            member[from] = inside;
    } while (*at != ']');
    return at + 1;
}

/* Does %s, %c and %[; gives the number of characters, and advances *format over a set. */
static int scan_string(struct source *source, const struct conversion *conversion, int letter,
                       const char **format, char *to)
{
    char member[256];
    int most = conversion->width > 0 ? conversion->width : letter == 'c' ? 1 : 0x7fffffff;
    int size, c;

    if (letter == '[') {
        *format = read_set(*format, member);
    } else {
        for (c = 0; c < 256; c++)
            member[c] = letter == 'c' || !isspace(c);
    }
    size = scan_characters(source, most, member, to);
    if (letter == 'c')
        return size == most;
    if (to != NULL && size > 0)
        to[size] = 0;
    return size;
}

/* Reads star, width and length of a conversion; gives the place of its letter. */
static const char *read_conversion(const char *at, struct conversion *conversion)
{
    conversion->suppressed = *at == '*';
    at += conversion->suppressed;
    conversion->width = conversion->length = 0;
    for (; isdigit(*at); at++)
        if (conversion->width < 100000000)
            conversion->width = conversion->width * 10 + *at - '0';
    if (*at && strchr("hlqLjzt", *at) != NULL) {
        conversion->length = *at++;
        if (conversion->length == *at && (*at == 'h' || *at == 'l'))
            conversion->length = *at++ == 'h' ? 'H' : 'q';
        if (conversion->length == 'L' || conversion->length == 'j')
            conversion->length = 'q';
    }
    return at;
}

/* Does one conversion; gives 1 when it matched, 0 when not, EOF when the input ended before. */
static int scan_one(struct source *source, const struct conversion *conversion, int letter,
                    const char **format, void *to)
{
    int c;

    if (letter == 'n') {
        if (to != NULL)
            store_integer(to, conversion->length, source->count);
        return 1;
    }
    if (letter != 'c' && letter != '[') {
        c = skip_space(source);
    } else {
        c = next(source);
        put_back(source, c);
    }
    if (c == EOF)
        return EOF;
    switch (letter) {
    case 'd': case 'i': case 'o': case 'u': case 'x': case 'X': case 'p':
        return scan_integer(source, conversion, letter, to);
    case 'a': case 'A': case 'e': case 'E': case 'f': case 'F': case 'g': case 'G':
        return scan_float(source, conversion, to);
    case 'c': case 's': case '[':
        return scan_string(source, conversion, letter, format, to) > 0;
    }
    return 0;
}

/* Matches white space or one ordinary character of the format; gives 1, 0 or EOF. */
static int match(struct source *source, int expected)
{
    int c;

    if (isspace(expected)) {
        skip_space(source);
        return 1;
    }
    c = next(source);
    if (c == expected)
        return 1;
    put_back(source, c);
    return c == EOF ? EOF : 0;
}

static int scan(struct source *source, const char *format, va_list arguments)
{
    struct conversion conversion;
    int assigned = 0, result;
    va_list rest;

    va_copy(rest, arguments);
    while (*format) {
        if (*format == '%' && format[1] != '%') {
            void *to = NULL;
            int letter;
            format = read_conversion(format + 1, &conversion);
            letter = *format;
            format += letter != 0;
            if (!conversion.suppressed && letter != 0)
                to = va_arg(rest, void *);
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

int vfscanf(FILE *stream, const char *format, va_list arguments)
{
    struct source source = {stream, NULL, 0};

    return scan(&source, format, arguments);
}

int vscanf(const char *format, va_list arguments)
{
    return vfscanf(stdin, format, arguments);
}

int vsscanf(const char *text, const char *format, va_list arguments)
{
    struct source source = {NULL, text, 0};

    return scan(&source, format, arguments);
}

int scanf(const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vfscanf(stdin, format, arguments);
    va_end(arguments);
    return result;
}

int fscanf(FILE *stream, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vfscanf(stream, format, arguments);
    va_end(arguments);
    return result;
}

int sscanf(const char *text, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = vsscanf(text, format, arguments);
    va_end(arguments);
    return result;
}
