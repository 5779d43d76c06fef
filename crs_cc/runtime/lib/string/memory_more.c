/* GNU extensions for byte arrays (string.h). */
#include <string.h>

void *mempcpy(void *to, const void *from, size_t size)
{
    __builtin_memcpy(to, from, size);
    return (char *)to + size;
}

void *memrchr(const void *bytes, int c, size_t size)
{
    const unsigned char *at = (const unsigned char *)bytes + size;

    while (size-- > 0)
        if (*--at == (unsigned char)c)
            return (void *)at;
    return NULL;
}

void *rawmemchr(const void *bytes, int c)
{
    const unsigned char *at = bytes;

    while (*at != (unsigned char)c)
        at++;
    return (void *)at;
}

void *memmem(const void *bytes, size_t size, const void *part, size_t part_size)
{
    const char *at = bytes;

    for (; size >= part_size; at++, size--)
        if (part_size == 0 || memcmp(at, part, part_size) == 0)
            return (void *)at;
    return NULL;
}

int ffsl(long value)
{
    return value == 0 ? 0 : __builtin_ctz(value) + 1;
}

int ffsll(long long value)
{
    return value == 0 ? 0 : __builtin_ctzll(value) + 1;
}

void explicit_bzero(void *bytes, size_t size)
{
    __builtin_memset(bytes, 0, size);
}
