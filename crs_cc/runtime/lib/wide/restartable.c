/* Multibyte characters that arrive in pieces (C17 7.29.6 and 7.28.1). */
#include <errno.h>
#include <stdlib.h>
#include <uchar.h>
#include <wchar.h>

#include <crs/utf8.h>

static size_t wrong(mbstate_t *state)
{
    state->missing = state->length = 0;
    errno = EILSEQ;
    return -1;
}

static const unsigned int least[] = {0, 0, 0x80, 0x800, 0x10000};

/* Starts a character with its first byte, from an empty state. */
static int begin(mbstate_t *state, unsigned char byte)
{
    int length = byte < 0x80 ? 1 : byte < 0xc2 ? 0 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 :
                 byte < 0xf5 ? 4 : 0;

    state->length = length;
    state->missing = length - 1;
    state->value = length == 1 ? byte : byte & 0x7f >> length;
    return length;
}

/* Returns the bytes taken, 0 for the null character, -1 for wrong ones, -2 when more are needed. */
static size_t decode(unsigned int *wide, const char *text, size_t size, mbstate_t *state)
{
    size_t taken = 0;
    unsigned char byte;

    for (; taken < size; taken++) {
        byte = text[taken];
        if (state->length == 0) {
            if (begin(state, byte) == 0)
                return wrong(state);
        } else {
            if ((byte & 0xc0) != 0x80)
                return wrong(state);
            state->value = state->value << 6 | (byte & 0x3f);
            state->missing--;
        }
        if (state->missing > 0)
            continue;
        *wide = state->value;
        if (*wide < least[state->length] || *wide > 0x10ffff ||
            (*wide >= 0xd800 && *wide < 0xe000))
            return wrong(state);
        state->length = 0;
        return *wide == 0 ? 0 : taken + 1;
    }
    return -2;
}

int mbsinit(const mbstate_t *state)
{
    return state == NULL || state->length == 0;
}

/* Reads one character as `mbrtowc` does. Without a text the state is reset. */
static size_t read_character(unsigned int *wide, const char *text, size_t size, mbstate_t *state)
{
    unsigned int c = 0;
    size_t result = decode(&c, text == NULL ? "" : text, text == NULL ? 1 : size, state);

    if (wide != NULL && text != NULL && result < (size_t)-2)
        *wide = c;
    return result;
}

size_t mbrtowc(wchar_t *wide, const char *text, size_t size, mbstate_t *state)
{
    static mbstate_t own;

    return read_character((unsigned int *)wide, text, size, state == NULL ? &own : state);
}

size_t mbrlen(const char *text, size_t size, mbstate_t *state)
{
    static mbstate_t own;
    unsigned int c;

    return decode(&c, text == NULL ? "" : text, text == NULL ? 1 : size,
                  state == NULL ? &own : state);
}

static size_t encode(char *text, unsigned int wide)
{
    return text == NULL ? 1 : (size_t)__crs_encode(text, wide);
}

size_t wcrtomb(char *text, wchar_t wide, mbstate_t *state)
{
    (void)state;
    return encode(text, wide);
}

size_t mbsrtowcs(wchar_t *wide, const char **text, size_t size, mbstate_t *state)
{
    static mbstate_t own;
    const char *at = *text;
    size_t count = 0, length;
    unsigned int c;

    if (state == NULL)
        state = &own;
    for (; wide == NULL || count < size; count++) {
        for (length = (size_t)-2; length == (size_t)-2;)
            length = decode(&c, at++, 1, state);
        if (length == (size_t)-1) {
            if (wide != NULL)
                *text = at - 1;
            return length;
        }
        if (wide != NULL) {
            wide[count] = c;
            *text = c == 0 ? NULL : at;
        }
        if (c == 0)
            break;
    }
    return count;
}

size_t wcsrtombs(char *text, const wchar_t **wide, size_t size, mbstate_t *state)
{
    const wchar_t *at = *wide;
    size_t count = 0;
    char bytes[4];
    int length;

    (void)state;
    for (;; at++) {
        length = __crs_encode(bytes, *at);
        if (text != NULL)
            *wide = at;
        if (length < 0)
            return -1;
        if (text != NULL && count + length > size)
            return count;
        if (text != NULL)
            __builtin_memcpy(text + count, bytes, length);
        if (*at == 0)
            break;
        count += length;
    }
    if (text != NULL)
        *wide = NULL;
    return count;
}

size_t mbrtoc32(char32_t *c, const char *text, size_t size, mbstate_t *state)
{
    static mbstate_t own;

    return read_character(c, text, size, state == NULL ? &own : state);
}

size_t c32rtomb(char *text, char32_t c, mbstate_t *state)
{
    (void)state;
    return encode(text, c);
}

/* A character beyond 16 bits is returned in two halves, the second one without reading more: -3.
   The pending half is stored in the state, marked by a negative length. */
size_t mbrtoc16(char16_t *c, const char *text, size_t size, mbstate_t *state)
{
    static mbstate_t own;
    unsigned int found = 0;
    size_t result;

    if (state == NULL)
        state = &own;
    if (state->length < 0) {
        state->length = 0;
        if (c != NULL)
            *c = state->value;
        return -3;
    }
    result = decode(&found, text == NULL ? "" : text, text == NULL ? 1 : size, state);
    if (result >= (size_t)-2)
        return result;
    if (found > 0xffff) {
        state->value = 0xdc00 | (found & 0x3ff);
        state->length = -1;
        found = 0xd7c0 + (found >> 10);
    }
    if (c != NULL && text != NULL)
        *c = found;
    return result;
}

size_t c16rtomb(char *text, char16_t c, mbstate_t *state)
{
    static mbstate_t own;

    if (state == NULL)
        state = &own;
    if (text == NULL)
        return 1;
    if (state->length < 0) {
        state->length = 0;
        if (c < 0xdc00 || c > 0xdfff)
            return wrong(state);
        return encode(text, 0x10000 + ((state->value & 0x3ff) << 10) + (c & 0x3ff));
    }
    if (c < 0xd800 || c > 0xdbff)
        return encode(text, c);
    state->value = c;
    state->length = -1;
    return 0;
}
