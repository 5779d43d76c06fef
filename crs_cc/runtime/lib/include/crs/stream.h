/* A stream, and what the parts of stdio share. */
#ifndef CRS_STREAM_H
#define CRS_STREAM_H

#include <stdio.h>

#define PUSHBACK 8   /* bytes kept free at the front of an input buffer for ungetc */

enum { AT_END = 1, FAILED = 2, READS = 4, WRITES = 8 };

struct __crs_file {
    int descriptor;
    int mode;                  /* _IOFBF, _IOLBF or _IONBF */
    int flags;
    unsigned char *buffer;
    int capacity;
    int begin, end;            /* input not yet read, or output not yet written, in the buffer */
    int line_end;              /* behind the last newline in the output, 0 when there is none */
    struct __crs_file *next;   /* in the list of all streams */
};

extern FILE *__crs_streams;

/* Appends output; gives 0, or EOF on error. Nothing leaves before the buffer is full. */
int __crs_append(FILE *stream, const void *bytes, int size);

/* Lets out what must not wait: whole lines of a line-buffered stream, all of an unbuffered one. */
int __crs_settle(FILE *stream);

/* Writes out the buffer; gives 0, or EOF on error. */
int __crs_flush(FILE *stream);
void __crs_flush_all(void);

/* Gives the next byte of input, or EOF. */
int __crs_next(FILE *stream);

#endif
