/* Copying, joining and comparing strings (C17 7.24; the last few: POSIX and BSD). */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <crs/overlap.h>

size_t strlen(const char *text)
{
    const char *end = text;

    while (*end)
        end++;
    return end - text;
}

size_t strnlen(const char *text, size_t size)
{
    size_t length = 0;

    while (length < size && text[length])
        length++;
    return length;
}

char *strcpy(char *to, const char *from)
{
    char *at = to;
    const char *start = from;

    while ((*at++ = *from++) != 0)
        if (from == to)
            __crs_stop("overlapping copy", to);
    CRS_KEEP_APART(to, start, at - to);
    return to;
}

char *stpcpy(char *to, const char *from)
{
    return strcpy(to, from) + strlen(from);
}

char *strncpy(char *to, const char *from, size_t size)
{
    size_t i = 0;

    for (; i < size && from[i]; i++)
        to[i] = from[i];
    CRS_KEEP_APART(to, from, i < size ? i + 1 : i);
    for (; i < size; i++)
        to[i] = 0;
    return to;
}

char *strcat(char *to, const char *from)
{
    strcpy(to + strlen(to), from);
    return to;
}

char *strncat(char *to, const char *from, size_t size)
{
    char *end = to + strlen(to), *at = end;

    while (size-- > 0 && *from) {
        *at++ = *from++;
        if (from == end)
            __crs_stop("overlapping copy", to);
    }
    *at = 0;
    return to;
}

int strcmp(const char *left, const char *right)
{
    while (*left && *left == *right) {
        left++;
        right++;
    }
    return (unsigned char)*left - (unsigned char)*right;
}

int strncmp(const char *left, const char *right, size_t size)
{
    for (; size > 0; size--, left++, right++) {
        if (*left != *right)
            return (unsigned char)*left - (unsigned char)*right;
        if (*left == 0)
            break;
    }
    return 0;
}

/* The "C" locale orders by byte. */
int strcoll(const char *left, const char *right)
{
    return strcmp(left, right);
}

size_t strxfrm(char *to, const char *from, size_t size)
{
    size_t length = strlen(from);

    if (length < size)
        strcpy(to, from);
    return length;
}

char *strdup(const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = malloc(size);

    if (copy != NULL)
        __builtin_memcpy(copy, text, size);
    return copy;
}

char *strndup(const char *text, size_t size)
{
    size_t length = 0;
    char *copy;

    while (length < size && text[length])
        length++;
    copy = malloc(length + 1);
    if (copy != NULL) {
        __builtin_memcpy(copy, text, length);
        copy[length] = 0;
    }
    return copy;
}

int strcasecmp(const char *left, const char *right)
{
    int l, r;

    do {
        l = tolower((unsigned char)*left++);
        r = tolower((unsigned char)*right++);
    } while (l == r && l != 0);
    return l - r;
}

int strncasecmp(const char *left, const char *right, size_t size)
{
    for (; size > 0; size--, left++, right++) {
        int l = tolower((unsigned char)*left), r = tolower((unsigned char)*right);
        if (l != r || l == 0)
            return l - r;
    }
    return 0;
}
