/* Formatted input: its source, and one conversion specification. */
#ifndef CRS_SCAN_H
#define CRS_SCAN_H

#include <stdio.h>

/* The source of the characters: a stream, or a string if `stream` is null. */
struct __crs_source {
    FILE *stream;
    const char *text;
    int count;           /* characters read so far */
};

struct __crs_input {
    int position;        /* number of the argument, 0 for the next */
    int suppressed;      /* 1 when the value is not stored */
    int width;           /* 0 when absent */
    int allocates;       /* 1 if the text is stored in a new block (POSIX's %ms) */
    int length;          /* 'H' for hh, 'q' for ll, j and L, else the letter itself, or 0 */
};

/* Returns the next character, or EOF. */
int __crs_next_input(struct __crs_source *source);

/* Pushes back the last character; EOF changes nothing. */
void __crs_put_back(struct __crs_source *source, int c);

/* These read a number and store it unless `to` is null; they return 0 if there is none. */
int __crs_scan_integer(struct __crs_source *source, const struct __crs_input *conversion,
                       int letter, void *to);
int __crs_scan_float(struct __crs_source *source, const struct __crs_input *conversion, void *to);

/* Stores an integer of the size that a length modifier names. */
void __crs_store_integer(void *to, int length, unsigned long long value);

#endif
