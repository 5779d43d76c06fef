/* BSD and GNU extensions for strings (string.h). */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

char *strchrnul(const char *text, int c)
{
    while (*text && *text != (char)c)
        text++;
    return (char *)text;
}

char *strcasestr(const char *text, const char *part)
{
    size_t i;

    for (;; text++) {
        for (i = 0; part[i]; i++)
            if (tolower((unsigned char)text[i]) != tolower((unsigned char)part[i]))
                break;
        if (part[i] == 0)
            return (char *)text;
        if (*text == 0)
            return NULL;
    }
}

/* Both return the length of the untruncated text (OpenBSD). */
size_t strlcpy(char *to, const char *from, size_t size)
{
    size_t length = strlen(from), copied = length < size ? length : size - 1;

    if (size > 0) {
        __builtin_memcpy(to, from, copied);
        to[copied] = 0;
    }
    return length;
}

size_t strlcat(char *to, const char *from, size_t size)
{
    size_t begun = 0, length = strlen(from), copied;

    while (begun < size && to[begun])
        begun++;
    if (begun < size) {
        copied = length < size - begun ? length : size - begun - 1;
        __builtin_memcpy(to + begun, from, copied);
        to[begun + copied] = 0;
    }
    return begun + length;
}

char *stpncpy(char *to, const char *from, size_t size)
{
    size_t i = 0, end;

    for (; i < size && from[i]; i++)
        to[i] = from[i];
    end = i;
    for (; i < size; i++)
        to[i] = 0;
    return to + end;
}

/* Exchanges neighbouring bytes. */
void swab(const void *from, void *to, int size)
{
    const char *f = from;
    char *t = to, first;

    for (; size > 1; size -= 2, f += 2, t += 2) {
        first = f[0];
        t[0] = f[1];
        t[1] = first;
    }
}

/* An error's text, put into the caller's buffer if it must be (GNU's form). */
char *strerror_r(int number, char *text, size_t size)
{
    char *known = strerror(number);

    if (size == 0)
        return known;
    text[0] = 0;
    return strncat(text, known, size - 1);
}
