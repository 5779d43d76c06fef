/* Formatted input of numbers (C17 7.21.6.2p12). One of more than 511 characters ends there. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <crs/stream.h>

#include "scan.h"

#define ROOM 512

/* An input item as it grows: at most `width` characters that fit its grammar. */
struct item {
    struct __crs_source *source;
    int width, size;
    char text[ROOM];
};

int __crs_next_input(struct __crs_source *source)
{
    int c;

    if (source->stream != NULL)
        c = __crs_next(source->stream);
    else
        c = *source->text ? (unsigned char)*source->text++ : EOF;
    source->count += c != EOF;
    return c;
}

void __crs_put_back(struct __crs_source *source, int c)
{
    if (c == EOF)
        return;
    source->count--;
    if (source->stream != NULL)
        ungetc(c, source->stream);
    else
        source->text--;
}

/* Appends the next character to the item if it is in the set; returns it, or 0. */
static int accept(struct item *item, const char *set)
{
    int c;

    if (item->size == item->width)
        return 0;
    c = __crs_next_input(item->source);
    if (c > 0 && strchr(set, c) != NULL)
        return item->text[item->size++] = c;
    __crs_put_back(item->source, c);
    return 0;
}

static int accept_all(struct item *item, const char *set)
{
    int size = item->size;

    while (accept(item, set))
        ;
    return item->size - size;
}

static void open_item(struct item *item, struct __crs_source *source, int width)
{
    item->source = source;
    item->size = 0;
    item->width = width > 0 && width < ROOM - 1 ? width : ROOM - 1;
}

static const char decimal_digits[] = "0123456789", hexadecimal_digits[] = "0123456789abcdefABCDEF";

/* Converts the text of an integer; values out of range become the limit of the type. */
static unsigned long long convert(const char *text, int base, int is_signed, int is_long_long)
{
    if (is_long_long)
        return is_signed ? (unsigned long long)strtoll(text, NULL, base)
                         : strtoull(text, NULL, base);
    return is_signed ? (unsigned long long)strtol(text, NULL, base) : strtoul(text, NULL, base);
}

/* Reads the characters of an integer and finds its base; returns 0 if there is none. */
static int read_integer(struct item *item, int *found)
{
    const char *digits = decimal_digits;
    int any, base = *found;

    accept(item, "+-");
    any = accept(item, "0");
    if (any && (base == 0 || base == 16) && accept(item, "xX"))
        base = 16;
    else if (any && base == 0)
        base = 8;
    if (base == 2)
        digits = "01";
    if (base == 16)
        digits = hexadecimal_digits;
    if (base == 8)
        digits = "01234567";
    *found = base;
    return accept_all(item, digits) > 0 || any;
}

/* Reads letters as long as they spell the word, in either case. */
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

/* Reads the characters of a floating-point number; returns 0 if they are none. As on Linux an
   exponent may lack its digits, and is then ignored. */
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
        accept_all(item, decimal_digits);
    }
    return 1;
}

void __crs_store_integer(void *to, int length, unsigned long long value)
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

int __crs_scan_integer(struct __crs_source *source, const struct __crs_input *conversion,
                       int letter, void *to)
{
    struct item item;
    int base = letter == 'd' || letter == 'u' ? 10 : letter == 'i' ? 0 : letter == 'o' ? 8
               : letter == 'b'                ? 2
                                              : 16;

    open_item(&item, source, conversion->width);
    if (!read_integer(&item, &base))
        return 0;
    item.text[item.size] = 0;
    if (to != NULL)
        __crs_store_integer(to, conversion->length,
                            convert(item.text, base, letter == 'd' || letter == 'i',
                                    conversion->length == 'q'));
    return 1;
}

int __crs_scan_float(struct __crs_source *source, const struct __crs_input *conversion, void *to)
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
