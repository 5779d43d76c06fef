/* Multibyte strings, without a state that is kept (C17 7.22.7 and 7.22.8). */
#include <stdlib.h>

#include <crs/utf8.h>

int mbtowc(wchar_t *wide, const char *text, size_t size)
{
    unsigned int c;
    int length;

    if (text == NULL)
        return 0;
    length = __crs_decode(&c, text, size);
    if (length >= 0 && wide != NULL)
        *wide = c;
    return length < 0 ? -1 : length;
}

int mblen(const char *text, size_t size)
{
    return mbtowc(NULL, text, size);
}

int wctomb(char *text, wchar_t wide)
{
    return text == NULL ? 0 : __crs_encode(text, wide);
}

size_t mbstowcs(wchar_t *wide, const char *text, size_t size)
{
    size_t count = 0;
    unsigned int c;
    int length;

    for (; wide == NULL || count < size; count++) {
        length = __crs_decode(&c, text, MB_CUR_MAX);
        if (length < 0)
            return -1;
        if (wide != NULL)
            wide[count] = c;
        if (length == 0)
            break;
        text += length;
    }
    return count;
}

size_t wcstombs(char *text, const wchar_t *wide, size_t size)
{
    size_t count = 0;
    char bytes[4];
    int length;

    for (; *wide; wide++) {
        length = __crs_encode(bytes, *wide);
        if (length < 0)
            return -1;
        if (text != NULL) {
            if (count + length > size)
                return count;
            __builtin_memcpy(text + count, bytes, length);
        }
        count += length;
    }
    if (text != NULL && count < size)
        text[count] = 0;
    return count;
}
