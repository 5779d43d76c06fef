/* Lines of any length, and formatted output to new strings and to descriptors (POSIX, GNU, BSD). */
#include <errno.h>
#include <stdlib.h>

#include <crs/descriptor.h>
#include <crs/stream.h>

/* Reads up to and with the character `end` into a block that grows as it must. */
static ssize_t read_until(char **line, size_t *size, int end, FILE *stream)
{
    size_t length = 0;
    int c = 0;

    if (*line == NULL)
        *size = 0;
    while (c != end || length == 0) {
        if (length + 2 > *size) {
            size_t larger = *size < 60 ? 120 : *size * 2;
            char *block = realloc(*line, larger);
            if (block == NULL)
                return -1;
            *line = block;
            *size = larger;
        }
        c = __crs_next(stream);
        if (c == EOF)
            break;
        (*line)[length++] = c;
    }
    (*line)[length] = 0;
    return length == 0 ? -1 : (ssize_t)length;
}

ssize_t getdelim(char **line, size_t *size, int end, FILE *stream)
{
    return read_until(line, size, end, stream);
}

ssize_t getline(char **line, size_t *size, FILE *stream)
{
    return read_until(line, size, '\n', stream);
}

static int print_to_block(char **text, const char *format, va_list arguments)
{
    char nothing[1];
    va_list again;
    int size;

    *text = NULL;
    va_copy(again, arguments);
    size = __crs_print_to_string(nothing, 0, format, again);
    va_end(again);
    if (size < 0 || (*text = malloc(size + 1)) == NULL)
        return -1;
    return __crs_print_to_string(*text, size, format, arguments);
}

int vasprintf(char **text, const char *format, va_list arguments)
{
    return print_to_block(text, format, arguments);
}

int asprintf(char **text, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = print_to_block(text, format, arguments);
    va_end(arguments);
    return result;
}

static int print_to_descriptor(int descriptor, const char *format, va_list arguments)
{
    char *text;
    int size = print_to_block(&text, format, arguments);

    if (size >= 0 && __crs_put(descriptor, text, size) < 0)
        size = -1;
    free(text);
    return size;
}

int vdprintf(int descriptor, const char *format, va_list arguments)
{
    return print_to_descriptor(descriptor, format, arguments);
}

int dprintf(int descriptor, const char *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = print_to_descriptor(descriptor, format, arguments);
    va_end(arguments);
    return result;
}

/* The line stays where it is until the next call; no zero ends it (BSD). */
char *fgetln(FILE *stream, size_t *length)
{
    static char *line;
    static size_t size;
    ssize_t count = read_until(&line, &size, '\n', stream);

    *length = count < 0 ? 0 : count;
    return count < 0 ? NULL : line;
}
