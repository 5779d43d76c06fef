/* Wide strings to numbers (C17 7.29.4.1): those of the same text in ASCII. */
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

/* Copies a text up to its first character beyond ASCII, which no number has. */
static char *narrow(const wchar_t *text)
{
    size_t length = 0, i;
    char *copy;

    while (text[length] > 0 && text[length] < 128)
        length++;
    copy = malloc(length + 1);
    if (copy == NULL)
        return NULL;
    for (i = 0; i < length; i++)
        copy[i] = text[i];
    copy[length] = 0;
    return copy;
}

#define CONVERT(type, name, parameters, call)               \
    type name parameters                                    \
    {                                                       \
        char *copy = narrow(text), *behind = copy;          \
        type value = 0;                                     \
                                                            \
        if (copy != NULL)                                   \
            value = call;                                   \
        if (end != NULL)                                    \
            *end = (wchar_t *)text + (behind - copy);       \
        free(copy);                                         \
        return value;                                       \
    }

CONVERT(long, wcstol, (const wchar_t *text, wchar_t **end, int base), strtol(copy, &behind, base))
CONVERT(unsigned long, wcstoul, (const wchar_t *text, wchar_t **end, int base),
        strtoul(copy, &behind, base))
CONVERT(long long, wcstoll, (const wchar_t *text, wchar_t **end, int base),
        strtoll(copy, &behind, base))
CONVERT(unsigned long long, wcstoull, (const wchar_t *text, wchar_t **end, int base),
        strtoull(copy, &behind, base))
CONVERT(double, wcstod, (const wchar_t *text, wchar_t **end), strtod(copy, &behind))
CONVERT(float, wcstof, (const wchar_t *text, wchar_t **end), strtof(copy, &behind))
CONVERT(long double, wcstold, (const wchar_t *text, wchar_t **end), strtold(copy, &behind))
