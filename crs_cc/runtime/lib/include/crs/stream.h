/* Streams: the declarations shared by the parts of stdio. */
#ifndef CRS_STREAM_H
#define CRS_STREAM_H

#include <stdio.h>

#define PUSHBACK 8   /* bytes kept free at the front of an input buffer for ungetc */

enum { AT_END = 1, FAILED = 2, READS = 4, WRITES = 8, OUTPUT = 16, OWNED = 32, BACKED = 64 };

struct __crs_file {
    int descriptor;
    int mode;                  /* _IOFBF, _IOLBF or _IONBF */
    int flags;                 /* OUTPUT: the buffer holds output; OWNED: made by malloc */
    unsigned char *buffer;
    int capacity;
    int begin, end;            /* input not yet read, or output not yet written, in the buffer */
    int line_end;              /* after the last newline in the output, 0 if there is none */
    struct __crs_file *next;   /* in the list of all streams */
    int orientation;           /* of wide characters; 0 when not yet known */
};

/* A stream without a descriptor, BACKED by functions that do what the system does for others. */
struct __crs_backed {
    FILE stream;
    int (*put)(FILE *stream, const void *bytes, int size);
    int (*read)(FILE *stream, void *bytes, int size);
    long (*seek)(FILE *stream, long offset, int whence);
    int (*close)(FILE *stream);
};

extern FILE *__crs_streams;

/* Appends output; returns 0, or EOF on error. Nothing leaves before the buffer is full. */
int __crs_append(FILE *stream, const void *bytes, int size);

/* Flushes whole lines of a line-buffered stream, and everything of an unbuffered one. */
int __crs_settle(FILE *stream);

/* Writes out the buffer; returns 0, or EOF on error. */
int __crs_flush(FILE *stream);
void __crs_flush_all(void);

/* Flushes the buffer: writes output, or discards input and seeks back to the read position. */
int __crs_synchronise(FILE *stream);

/* Moves a stream's position below its buffer, as lseek does. */
long __crs_move(FILE *stream, long offset, int whence);

/* Returns the next byte of input, or EOF. */
int __crs_next(FILE *stream);

/* Reads bytes; returns their number, less than `size` at end of file. */
size_t __crs_take(FILE *stream, void *bytes, size_t size);

/* Reads a mode such as "r+b"; returns flags for open, -1 with errno when it is none. */
int __crs_open_flags(const char *mode);

/* Makes a stream of `size` bytes, which begin with a FILE, around a descriptor; returns null with
   errno on error. */
FILE *__crs_make_stream(int descriptor, int flags, size_t size);

/* Prints to a string of `room` characters and a final null; returns the untruncated length. */
int __crs_print_to_string(char *text, unsigned int room, const char *format, va_list arguments);

/* Formatted input, from a stream and from a string. */
int __crs_scan_stream(FILE *stream, const char *format, va_list arguments);
int __crs_scan_string(const char *text, const char *format, va_list arguments);

#endif
