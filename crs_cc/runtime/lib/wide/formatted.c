/* Formatted wide input and output (C17 7.29.2): that of the same format in UTF-8. Widths and
   precisions count bytes. */
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <time.h>
#include <wchar.h>

#include <crs/stream.h>
#include <crs/utf8.h>

static int print_to_stream(FILE *stream, const wchar_t *format, va_list arguments)
{
    char *narrow = __crs_encode_string(format);
    int result = narrow == NULL ? -1 : vfprintf(stream, narrow, arguments);

    free(narrow);
    return result;
}

/* Returns the number of characters, or -1 when they do not fit (C17 7.29.2.3p3). */
static int print_to_string(wchar_t *text, size_t size, const wchar_t *format, va_list arguments)
{
    char *narrow = __crs_encode_string(format), *printed, nothing[1];
    size_t count = size;
    va_list again;
    int bytes;

    va_copy(again, arguments);
    bytes = narrow == NULL ? -1 : __crs_print_to_string(nothing, 0, narrow, again);
    va_end(again);
    printed = bytes < 0 ? NULL : malloc(bytes + 1);
    if (printed != NULL) {
        __crs_print_to_string(printed, bytes, narrow, arguments);
        count = mbstowcs(text, printed, size);
    }
    free(printed);
    free(narrow);
    if (count < size)
        return count;
    if (size > 0)
        text[size - 1] = 0;
    return -1;
}

int vfwprintf(FILE *stream, const wchar_t *format, va_list arguments)
{
    return print_to_stream(stream, format, arguments);
}

int vwprintf(const wchar_t *format, va_list arguments)
{
    return print_to_stream(stdout, format, arguments);
}

int vswprintf(wchar_t *text, size_t size, const wchar_t *format, va_list arguments)
{
    return print_to_string(text, size, format, arguments);
}

int wprintf(const wchar_t *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = print_to_stream(stdout, format, arguments);
    va_end(arguments);
    return result;
}

int fwprintf(FILE *stream, const wchar_t *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = print_to_stream(stream, format, arguments);
    va_end(arguments);
    return result;
}

int swprintf(wchar_t *text, size_t size, const wchar_t *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = print_to_string(text, size, format, arguments);
    va_end(arguments);
    return result;
}

static int scan_stream(FILE *stream, const wchar_t *format, va_list arguments)
{
    char *narrow = __crs_encode_string(format);
    int result = narrow == NULL ? EOF : __crs_scan_stream(stream, narrow, arguments);

    free(narrow);
    return result;
}

int wscanf(const wchar_t *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = scan_stream(stdin, format, arguments);
    va_end(arguments);
    return result;
}

int fwscanf(FILE *stream, const wchar_t *format, ...)
{
    va_list arguments;
    int result;

    va_start(arguments, format);
    result = scan_stream(stream, format, arguments);
    va_end(arguments);
    return result;
}

int swscanf(const wchar_t *text, const wchar_t *format, ...)
{
    char *narrow = __crs_encode_string(format), *input = __crs_encode_string(text);
    va_list arguments;
    int result = EOF;

    va_start(arguments, format);
    if (narrow != NULL && input != NULL)
        result = __crs_scan_string(input, narrow, arguments);
    va_end(arguments);
    free(narrow);
    free(input);
    return result;
}

size_t wcsftime(wchar_t *text, size_t size, const wchar_t *format, const struct tm *date)
{
    char *narrow = __crs_encode_string(format), *printed = malloc(4 * size + 1);
    size_t count = 0;

    if (narrow != NULL && printed != NULL && strftime(printed, 4 * size + 1, narrow, date) > 0)
        count = mbstowcs(text, printed, size);
    free(printed);
    free(narrow);
    return count < size ? count : 0;
}
