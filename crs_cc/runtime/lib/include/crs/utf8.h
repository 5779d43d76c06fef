/* UTF-8 (RFC 3629), for the library itself. */
#ifndef CRS_UTF8_H
#define CRS_UTF8_H

#include <stddef.h>

/* Writes a character to `text`, which has room for 4 bytes; returns its length, -1 and EILSEQ
   if it is not a character. */
int __crs_encode(char *text, unsigned int c);

/* Reads a character of `text`, which has at most `size` bytes; returns its length, 0 for the null
   character, -1 with errno EILSEQ for wrong bytes, -2 when more bytes are needed. */
int __crs_decode(unsigned int *c, const char *text, size_t size);

/* Returns the length of a wide string as UTF-8, or -1 with errno EILSEQ. */
int __crs_encoded_size(const wchar_t *text);

/* Makes a copy of a wide string as UTF-8; null with errno when that fails. */
char *__crs_encode_string(const wchar_t *text);

#endif
