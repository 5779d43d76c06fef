/* Character and direct input and output (C17 7.21.7 and 7.21.8; getw, putw: System V). */
#include <errno.h>
#include <string.h>

#include <crs/stream.h>

int fputc(int c, FILE *stream)
{
    unsigned char byte = c;

    return __crs_append(stream, &byte, 1) < 0 || __crs_settle(stream) < 0 ? EOF : byte;
}

int putc(int c, FILE *stream)
{
    return fputc(c, stream);
}

int putchar(int c)
{
    return fputc(c, stdout);
}

int fputs(const char *text, FILE *stream)
{
    return __crs_append(stream, text, strlen(text)) < 0 || __crs_settle(stream) < 0 ? EOF : 1;
}

/* Returns the number of characters, as glibc does. */
int puts(const char *text)
{
    int size = strlen(text);

    if (__crs_append(stdout, text, size) < 0 || __crs_append(stdout, "\n", 1) < 0)
        return EOF;
    return __crs_settle(stdout) < 0 ? EOF : size + 1;
}

size_t fwrite(const void *items, size_t size, size_t count, FILE *stream)
{
    if (size == 0 || count == 0)
        return 0;
    if (__crs_append(stream, items, size * count) < 0 || __crs_settle(stream) < 0)
        return 0;
    return count;
}

int fgetc(FILE *stream)
{
    return __crs_next(stream);
}

int getc(FILE *stream)
{
    return __crs_next(stream);
}

int getchar(void)
{
    return __crs_next(stdin);
}

char *fgets(char *text, int size, FILE *stream)
{
    char *at = text;
    int c = 0;

    if (size < 1)
        return NULL;
    while (--size > 0 && c != '\n' && (c = __crs_next(stream)) != EOF)
        *at++ = c;
    if (c == EOF && (at == text || stream->flags & FAILED))
        return NULL;
    *at = 0;
    return text;
}

int ungetc(int c, FILE *stream)
{
    if (c == EOF || !(stream->flags & READS))
        return EOF;
    if (stream->flags & OUTPUT) {
        __crs_synchronise(stream);
        stream->flags &= ~OUTPUT;
    }
    if (stream->begin == stream->end)
        stream->begin = stream->end = PUSHBACK;
    if (stream->begin == 0)
        return EOF;
    stream->buffer[--stream->begin] = c;
    stream->flags &= ~AT_END;
    return (unsigned char)c;
}

size_t fread(void *items, size_t size, size_t count, FILE *stream)
{
    if (size == 0 || count == 0)
        return 0;
    return __crs_take(stream, items, size * count) / size;
}

/* Reads a line however long it is, which no program can make safe: C11 took it away. */
char *gets(char *text)
{
    char *at = text;
    int c;

    while ((c = __crs_next(stdin)) != EOF && c != '\n')
        *at++ = c;
    if (c == EOF && (at == text || stdin->flags & FAILED))
        return NULL;
    *at = 0;
    return text;
}

int putw(int word, FILE *stream)
{
    return fwrite(&word, sizeof word, 1, stream) == 1 ? 0 : EOF;
}

int getw(FILE *stream)
{
    int word;

    return fread(&word, sizeof word, 1, stream) == 1 ? word : EOF;
}

void perror(const char *text)
{
    int number = errno;

    if (text != NULL && *text)
        fprintf(stderr, "%s: ", text);
    fprintf(stderr, "%s\n", strerror(number));
}
