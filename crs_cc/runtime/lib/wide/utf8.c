/* UTF-8 (RFC 3629). */
#include <errno.h>
#include <stdlib.h>

#include <crs/utf8.h>

static int wrong(void)
{
    errno = EILSEQ;
    return -1;
}

int __crs_encode(char *text, unsigned int c)
{
    int length = c < 0x80 ? 1 : c < 0x800 ? 2 : c < 0x10000 ? 3 : 4, i;

    if (c > 0x10ffff || (c >= 0xd800 && c < 0xe000))
        return wrong();
    if (length == 1) {
        *text = c;
        return 1;
    }
    for (i = length; i-- > 1; c >>= 6)
        text[i] = 0x80 | (c & 0x3f);
    *text = (0xf00 >> length & 0xf0) | c;
    return length;
}

int __crs_decode(unsigned int *c, const char *text, size_t size)
{
    const unsigned char *byte = (const unsigned char *)text;
    static const unsigned int least[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned int value;
    int length, i;

    if (size == 0)
        return -2;
    if (*byte < 0x80) {
        *c = *byte;
        return *byte != 0;
    }
    length = *byte < 0xc2 ? 0 : *byte < 0xe0 ? 2 : *byte < 0xf0 ? 3 : *byte < 0xf5 ? 4 : 0;
    if (length == 0)
        return wrong();
    value = *byte & 0x7f >> length;
    for (i = 1; i < length; i++) {
        if ((size_t)i == size)
            return -2;
        if ((byte[i] & 0xc0) != 0x80)
            return wrong();
        value = value << 6 | (byte[i] & 0x3f);
    }
    if (value < least[length] || value > 0x10ffff || (value >= 0xd800 && value < 0xe000))
        return wrong();
    *c = value;
    return length;
}

int __crs_encoded_size(const wchar_t *text)
{
    char bytes[4];
    int size = 0, length;

    for (; *text; text++) {
        length = __crs_encode(bytes, *text);
        if (length < 0)
            return -1;
        size += length;
    }
    return size;
}

char *__crs_encode_string(const wchar_t *text)
{
    int size = __crs_encoded_size(text);
    char *copy = size < 0 ? NULL : malloc(size + 1), *at = copy;

    if (copy == NULL)
        return NULL;
    for (; *text; text++)
        at += __crs_encode(at, *text);
    *at = 0;
    return copy;
}
