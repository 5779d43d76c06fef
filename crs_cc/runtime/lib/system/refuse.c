/* The report of a function that is not available to control programs. */
#include <errno.h>
#include <string.h>

#include <crs/refuse.h>
#include <crs/write.h>

void __crs_refuse(int *said, const char *function, int number)
{
    if (!*said) {
        *said = 1;
        __crs_complain(function, "() is not available to a simulated robot's program: it fails\n");
    }
    errno = number;
}
