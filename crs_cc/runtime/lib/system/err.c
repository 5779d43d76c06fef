/* Messages that begin with the program's name (BSD err.h, GNU error.h). */
#include <err.h>
#include <errno.h>
#include <error.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const char *__progname;

unsigned int error_message_count;

/* Prints "program: message: text of the error"; no text for an error number below 0. */
static void complain(int number, const char *format, va_list arguments)
{
    fprintf(stderr, "%s: ", __progname);
    if (format != NULL)
        vfprintf(stderr, format, arguments);
    if (number >= 0)
        fprintf(stderr, "%s%s", format != NULL ? ": " : "", strerror(number));
    fprintf(stderr, "\n");
}

/* Calls complain with the arguments after `format`. */
#define COMPLAIN(number)                        \
    do {                                        \
        va_list arguments;                      \
        int number_ = (number);                 \
                                                \
        va_start(arguments, format);            \
        complain(number_, format, arguments);   \
        va_end(arguments);                      \
    } while (0)

void vwarn(const char *format, va_list arguments)
{
    complain(errno, format, arguments);
}

void vwarnx(const char *format, va_list arguments)
{
    complain(-1, format, arguments);
}

void warn(const char *format, ...)
{
    COMPLAIN(errno);
}

void warnx(const char *format, ...)
{
    COMPLAIN(-1);
}

_Noreturn void verr(int status, const char *format, va_list arguments)
{
    complain(errno, format, arguments);
    exit(status);
}

_Noreturn void verrx(int status, const char *format, va_list arguments)
{
    complain(-1, format, arguments);
    exit(status);
}

_Noreturn void err(int status, const char *format, ...)
{
    COMPLAIN(errno);
    exit(status);
}

_Noreturn void errx(int status, const char *format, ...)
{
    COMPLAIN(-1);
    exit(status);
}

/* Here an error number of 0 has no text, and with a status of 0 the program continues. */
void error(int status, int number, const char *format, ...)
{
    fflush(stdout);
    COMPLAIN(number == 0 ? -1 : number);
    error_message_count++;
    if (status != 0)
        exit(status);
}

void error_at_line(int status, int number, const char *file, unsigned int line,
                   const char *format, ...)
{
    va_list arguments;

    fflush(stdout);
    fprintf(stderr, "%s:%s:%u: ", __progname, file, line);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    if (number != 0)
        fprintf(stderr, ": %s", strerror(number));
    fprintf(stderr, "\n");
    error_message_count++;
    if (status != 0)
        exit(status);
}
