/* Wide characters from and to streams, as UTF-8 (C17 7.29.3). */
#include <errno.h>
#include <wchar.h>

#include <crs/stream.h>
#include <crs/utf8.h>

/* Streams accept both kinds of characters; the first orientation is only recorded. */
int fwide(FILE *stream, int mode)
{
    if (stream->orientation == 0)
        stream->orientation = mode < 0 ? -1 : mode > 0;
    return stream->orientation;
}

static wint_t get(FILE *stream)
{
    char bytes[4];
    unsigned int c;
    int size = 0, length = -2, byte;

    while (length == -2) {
        byte = __crs_next(stream);
        if (byte == EOF) {
            if (size > 0)
                errno = EILSEQ;
            return WEOF;
        }
        bytes[size++] = byte;
        length = __crs_decode(&c, bytes, size);
    }
    if (length >= 0)
        return c;
    stream->flags |= FAILED;
    return WEOF;
}

static wint_t put(wchar_t c, FILE *stream)
{
    char bytes[4];
    int size = __crs_encode(bytes, c);

    if (size < 0)
        stream->flags |= FAILED;
    return size < 0 || __crs_append(stream, bytes, size) < 0 || __crs_settle(stream) < 0
               ? WEOF : (wint_t)c;
}

wint_t fgetwc(FILE *stream)
{
    return get(stream);
}

wint_t getwc(FILE *stream)
{
    return get(stream);
}

wint_t getwchar(void)
{
    return get(stdin);
}

wint_t ungetwc(wint_t c, FILE *stream)
{
    char bytes[4];
    int size = c == WEOF ? -1 : __crs_encode(bytes, c);

    if (size < 0)
        return WEOF;
    while (size-- > 0)
        if (ungetc((unsigned char)bytes[size], stream) == EOF)
            return WEOF;
    return c;
}

wchar_t *fgetws(wchar_t *text, int size, FILE *stream)
{
    wchar_t *at = text;
    wint_t c = 0;

    if (size < 1)
        return NULL;
    while (--size > 0 && c != '\n' && (c = get(stream)) != WEOF)
        *at++ = c;
    if (c == WEOF && (at == text || stream->flags & FAILED))
        return NULL;
    *at = 0;
    return text;
}

wint_t fputwc(wchar_t c, FILE *stream)
{
    return put(c, stream);
}

wint_t putwc(wchar_t c, FILE *stream)
{
    return put(c, stream);
}

wint_t putwchar(wchar_t c)
{
    return put(c, stdout);
}

int fputws(const wchar_t *text, FILE *stream)
{
    for (; *text; text++)
        if (put(*text, stream) == WEOF)
            return -1;
    return 1;
}
