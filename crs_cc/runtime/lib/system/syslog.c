/* The system's log (POSIX syslog.h), which is the standard error stream. */
#include <stdio.h>
#include <syslog.h>

static const char *name;
static int mask = 0xff;

void openlog(const char *own, int options, int facility)
{
    (void)options;
    (void)facility;
    name = own;
}

void closelog(void)
{
    name = NULL;
}

int setlogmask(int wanted)
{
    int before = mask;

    if (wanted != 0)
        mask = wanted;
    return before;
}

static void print(int priority, const char *format, va_list arguments)
{
    if (!(mask & LOG_MASK(priority & LOG_PRIMASK)))
        return;
    if (name != NULL)
        fprintf(stderr, "%s: ", name);
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\n");
}

void vsyslog(int priority, const char *format, va_list arguments)
{
    print(priority, format, arguments);
}

void syslog(int priority, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    print(priority, format, arguments);
    va_end(arguments);
}
