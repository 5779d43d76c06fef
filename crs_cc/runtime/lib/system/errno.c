/* The number of the last error (C17 7.5). */
#include <errno.h>

int errno;
