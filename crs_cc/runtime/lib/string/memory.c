/* Bytes (C17 7.24; bcmp, bcopy, bzero: BSD). */
#include <string.h>

#include <crs/overlap.h>

void *memcpy(void *to, const void *from, size_t size)
{
    if (to != from)
        CRS_KEEP_APART(to, from, size);
    __builtin_memcpy(to, from, size);
    return to;
}

void *memmove(void *to, const void *from, size_t size)
{
    __builtin_memmove(to, from, size);
    return to;
}

void *memset(void *bytes, int value, size_t size)
{
    __builtin_memset(bytes, value, size);
    return bytes;
}

void bcopy(const void *from, void *to, size_t size)
{
    __builtin_memmove(to, from, size);
}

void bzero(void *bytes, size_t size)
{
    __builtin_memset(bytes, 0, size);
}

int memcmp(const void *left, const void *right, size_t size)
{
    const unsigned char *l = left, *r = right;

    for (; size > 0; size--, l++, r++)
        if (*l != *r)
            return *l - *r;
    return 0;
}

int bcmp(const void *left, const void *right, size_t size)
{
    return memcmp(left, right, size);
}

void *memchr(const void *bytes, int c, size_t size)
{
    const unsigned char *at = bytes;

    for (; size > 0; size--, at++)
        if (*at == (unsigned char)c)
            return (void *)at;
    return NULL;
}

void *memccpy(void *to, const void *from, int c, size_t size)
{
    unsigned char *t = to;
    const unsigned char *f = from;

    while (size-- > 0)
        if ((*t++ = *f++) == (unsigned char)c)
            return t;
    return NULL;
}
