/* Formatted output: its destination, and one conversion specification. */
#ifndef CRS_PRINT_H
#define CRS_PRINT_H

#include <stdio.h>

enum { LEFT = 1, PLUS = 2, SPACE = 4, ALTERNATE = 8, ZERO = 16 };

struct __crs_sink {
    FILE *stream;         /* null when the output goes to a string */
    char *text, *start;   /* where the next character goes, and the first went */
    unsigned int room;    /* bytes left in the string, without its final null character */
    unsigned int count;   /* characters printed so far, including those that did not fit */
    int failed;           /* errno of the first error, 0 for none */
};

struct __crs_conversion {
    int flags;
    int width;
    int precision;        /* -1 when absent */
    int width_from, precision_from;    /* number of the argument with its value, 0 for the next */
    int position;         /* number of the argument, 0 for the next */
    int length;           /* 'H' for hh, 'q' for ll, j and L, else the letter itself, or 0 */
    char letter;
};

void __crs_emit(struct __crs_sink *sink, const char *text, int size);
void __crs_pad(struct __crs_sink *sink, char c, int count);

/* Prints the prefix (a sign, 0x) of a field whose rest is `size` characters, with the padding that
   precedes and follows it; returns the padding that must follow the rest. */
int __crs_open_field(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                     const char *prefix, int prefix_size, int size);

/* These print a value by its conversion; a word is an argument of 4 bytes. */
void __crs_print_signed(struct __crs_sink *sink, struct __crs_conversion *conversion,
                        long long value);
void __crs_print_unsigned(struct __crs_sink *sink, struct __crs_conversion *conversion,
                          unsigned long long value);
void __crs_print_word(struct __crs_sink *sink, struct __crs_conversion *conversion, int value);
void __crs_print_double(struct __crs_sink *sink, const struct __crs_conversion *conversion,
                        double value);

#endif
