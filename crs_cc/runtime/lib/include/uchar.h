/* C17 7.28: characters of UTF-16 and UTF-32. */
#ifndef _UCHAR_H
#define _UCHAR_H

#include <stddef.h>
#include <stdint.h>
#include <wchar.h>

typedef uint_least16_t char16_t;
typedef uint_least32_t char32_t;

size_t mbrtoc16(char16_t *c, const char *text, size_t size, mbstate_t *state);
size_t c16rtomb(char *text, char16_t c, mbstate_t *state);
size_t mbrtoc32(char32_t *c, const char *text, size_t size, mbstate_t *state);
size_t c32rtomb(char *text, char32_t c, mbstate_t *state);

#endif
