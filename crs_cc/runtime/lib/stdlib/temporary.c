/* Names for temporary files that no file has yet (POSIX mkstemp, mktemp). */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <crs/descriptor.h>

/* Fills the XXXXXX at the end of a name, and opens a file of that name; -1 with errno if none. */
static int fill_and_open(char *name)
{
    size_t size = strlen(name);
    int number, descriptor;

    if (size < 6 || strcmp(name + size - 6, "XXXXXX") != 0) {
        errno = EINVAL;
        return -1;
    }
    for (number = 1; number < 1000000; number++) {
        sprintf(name + size - 6, "%06d", number);
        descriptor = __crs_open(name, O_RDWR | O_CREAT | O_EXCL);
        if (descriptor >= 0 || errno != EEXIST)
            return descriptor;
    }
    return -1;
}

int mkstemp(char *name)
{
    return fill_and_open(name);
}

char *mktemp(char *name)
{
    int descriptor = fill_and_open(name);

    if (descriptor < 0) {
        *name = 0;
        return name;
    }
    __crs_close(descriptor);
    remove(name);
    return name;
}
