/* Names of files (C17 7.21.4). */
#include <crs_request.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include <crs/descriptor.h>

int remove(const char *name)
{
    return __crs_by_name(CRS_FILE_REMOVE, name, 0);
}

int rename(const char *from, const char *to)
{
    char both[CRS_DATA_SIZE + 1];
    size_t size = strlen(from);

    if (size + strlen(to) > CRS_DATA_SIZE) {
        errno = ENAMETOOLONG;
        return -1;
    }
    strcpy(both, from);
    strcpy(both + size, to);
    return __crs_by_name(CRS_FILE_RENAME, both, size);
}

/* An unused file name: the numbers count up, so that two runs use the same names. */
char *tmpnam(char *name)
{
    static char own[L_tmpnam];
    static int count;

    if (name == NULL)
        name = own;
    sprintf(name, "/tmp/file%05d", ++count);
    return name;
}
