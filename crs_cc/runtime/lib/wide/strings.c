/* Wide strings (C17 7.29.4; wcsdup, wcsnlen, wcscasecmp: POSIX). */
#include <stdlib.h>
#include <wchar.h>
#include <wctype.h>

static size_t length_of(const wchar_t *text)
{
    size_t length = 0;

    while (text[length])
        length++;
    return length;
}

size_t wcslen(const wchar_t *text)
{
    return length_of(text);
}

size_t wcsnlen(const wchar_t *text, size_t size)
{
    size_t length = 0;

    while (length < size && text[length])
        length++;
    return length;
}

wchar_t *wcscpy(wchar_t *to, const wchar_t *from)
{
    __builtin_memmove(to, from, (length_of(from) + 1) * sizeof *to);
    return to;
}

wchar_t *wcsncpy(wchar_t *to, const wchar_t *from, size_t size)
{
    size_t i = 0;

    for (; i < size && from[i]; i++)
        to[i] = from[i];
    for (; i < size; i++)
        to[i] = 0;
    return to;
}

wchar_t *wcscat(wchar_t *to, const wchar_t *from)
{
    __builtin_memmove(to + length_of(to), from, (length_of(from) + 1) * sizeof *to);
    return to;
}

wchar_t *wcsncat(wchar_t *to, const wchar_t *from, size_t size)
{
    wchar_t *at = to + length_of(to);

    while (size-- > 0 && *from)
        *at++ = *from++;
    *at = 0;
    return to;
}

static int compare(const wchar_t *left, const wchar_t *right, size_t size)
{
    for (; size > 0; size--, left++, right++) {
        if (*left != *right)
            return *left < *right ? -1 : 1;
        if (*left == 0)
            break;
    }
    return 0;
}

int wcscmp(const wchar_t *left, const wchar_t *right)
{
    return compare(left, right, -1);
}

int wcsncmp(const wchar_t *left, const wchar_t *right, size_t size)
{
    return compare(left, right, size);
}

int wcscoll(const wchar_t *left, const wchar_t *right)
{
    return compare(left, right, -1);
}

int wcscasecmp(const wchar_t *left, const wchar_t *right)
{
    wint_t l, r;

    do {
        l = *left >= 'A' && *left <= 'Z' ? *left | 32 : *left;
        r = *right >= 'A' && *right <= 'Z' ? *right | 32 : *right;
        left++;
        right++;
    } while (l == r && l != 0);
    return l == r ? 0 : l < r ? -1 : 1;
}

size_t wcsxfrm(wchar_t *to, const wchar_t *from, size_t size)
{
    size_t length = length_of(from);

    if (length < size)
        __builtin_memcpy(to, from, (length + 1) * sizeof *to);
    return length;
}

static wchar_t *find(const wchar_t *text, wchar_t c)
{
    for (; *text != c; text++)
        if (*text == 0)
            return NULL;
    return (wchar_t *)text;
}

wchar_t *wcschr(const wchar_t *text, wchar_t c)
{
    return find(text, c);
}

wchar_t *wcsrchr(const wchar_t *text, wchar_t c)
{
    const wchar_t *found = NULL;

    do {
        if (*text == c)
            found = text;
    } while (*text++);
    return (wchar_t *)found;
}

wchar_t *wcsstr(const wchar_t *text, const wchar_t *part)
{
    size_t length = length_of(part);

    if (length == 0)
        return (wchar_t *)text;
    for (; (text = find(text, *part)) != NULL; text++)
        if (compare(text, part, length) == 0)
            return (wchar_t *)text;
    return NULL;
}

/* Counts the leading characters that are in the set, or that are not. */
static size_t span(const wchar_t *text, const wchar_t *set, int inside)
{
    size_t length = 0;

    while (text[length] && (find(set, text[length]) != NULL) == inside)
        length++;
    return length;
}

size_t wcsspn(const wchar_t *text, const wchar_t *accept)
{
    return span(text, accept, 1);
}

size_t wcscspn(const wchar_t *text, const wchar_t *reject)
{
    return span(text, reject, 0);
}

wchar_t *wcspbrk(const wchar_t *text, const wchar_t *accept)
{
    text += span(text, accept, 0);
    return *text ? (wchar_t *)text : NULL;
}

wchar_t *wcstok(wchar_t *text, const wchar_t *separators, wchar_t **rest)
{
    wchar_t *token;

    if (text == NULL)
        text = *rest;
    if (text == NULL)
        return NULL;
    token = text + span(text, separators, 1);
    text = token + span(token, separators, 0);
    *rest = *text ? text + 1 : NULL;
    if (token == text)
        return NULL;
    *text = 0;
    return token;
}

wchar_t *wcsdup(const wchar_t *text)
{
    size_t size = (length_of(text) + 1) * sizeof *text;
    wchar_t *copy = malloc(size);

    if (copy != NULL)
        __builtin_memcpy(copy, text, size);
    return copy;
}

wchar_t *wmemcpy(wchar_t *to, const wchar_t *from, size_t size)
{
    return __builtin_memcpy(to, from, size * sizeof *to);
}

wchar_t *wmemmove(wchar_t *to, const wchar_t *from, size_t size)
{
    return __builtin_memmove(to, from, size * sizeof *to);
}

wchar_t *wmemset(wchar_t *to, wchar_t c, size_t size)
{
    size_t i;

    for (i = 0; i < size; i++)
        to[i] = c;
    return to;
}

int wmemcmp(const wchar_t *left, const wchar_t *right, size_t size)
{
    for (; size > 0; size--, left++, right++)
        if (*left != *right)
            return *left < *right ? -1 : 1;
    return 0;
}

wchar_t *wmemchr(const wchar_t *text, wchar_t c, size_t size)
{
    for (; size > 0; size--, text++)
        if (*text == c)
            return (wchar_t *)text;
    return NULL;
}
