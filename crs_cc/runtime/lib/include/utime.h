/* POSIX utime.h: file times, which are not stored. */
#ifndef _UTIME_H
#define _UTIME_H

#include <time.h>

struct utimbuf {
    time_t actime, modtime;
};

int utime(const char *name, const struct utimbuf *times);

#endif
