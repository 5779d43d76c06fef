/* BSD's functions for the program's own name. */
#include <stdlib.h>
#include <string.h>

extern const char *__progname;

const char *getprogname(void)
{
    return __progname;
}

void setprogname(const char *name)
{
    const char *slash = strrchr(name, '/');

    __progname = slash == NULL ? name : slash + 1;
}
