/* POSIX utime.h: times of files, which nobody keeps. */
#ifndef _UTIME_H
#define _UTIME_H

#include <time.h>

struct utimbuf {
    time_t actime, modtime;
};

int utime(const char *name, const struct utimbuf *times);

#endif
