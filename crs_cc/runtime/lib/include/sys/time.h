/* POSIX sys/time.h, over simulated time. */
#ifndef _SYS_TIME_H
#define _SYS_TIME_H

#include <sys/types.h>

struct timeval {
    time_t tv_sec;
    suseconds_t tv_usec;
};

struct timezone {
    int tz_minuteswest;
    int tz_dsttime;
};

int gettimeofday(struct timeval *now, void *zone);

#define timerclear(time) ((time)->tv_sec = (time)->tv_usec = 0)
#define timerisset(time) ((time)->tv_sec || (time)->tv_usec)
#define timercmp(left, right, compare)                \
    ((left)->tv_sec == (right)->tv_sec                \
         ? (left)->tv_usec compare (right)->tv_usec   \
         : (left)->tv_sec compare (right)->tv_sec)

#endif
