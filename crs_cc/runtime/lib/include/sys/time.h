/* POSIX sys/time.h, in simulated time. */
#ifndef _SYS_TIME_H
#define _SYS_TIME_H

#include <sys/select.h>
#include <sys/types.h>

struct timezone {
    int tz_minuteswest;
    int tz_dsttime;
};

struct itimerval {
    struct timeval it_interval;
    struct timeval it_value;
};

#define ITIMER_REAL 0
#define ITIMER_VIRTUAL 1
#define ITIMER_PROF 2

int gettimeofday(struct timeval *now, void *zone);
int settimeofday(const struct timeval *now, const struct timezone *zone);
int setitimer(int which, const struct itimerval *wanted, struct itimerval *before);
int getitimer(int which, struct itimerval *now);

#define timerclear(time) ((time)->tv_sec = (time)->tv_usec = 0)
#define timerisset(time) ((time)->tv_sec || (time)->tv_usec)
#define timercmp(left, right, compare)                \
    ((left)->tv_sec == (right)->tv_sec                \
         ? (left)->tv_usec compare (right)->tv_usec   \
         : (left)->tv_sec compare (right)->tv_sec)
#define timeradd(left, right, sum)                                  \
    do {                                                            \
        (sum)->tv_sec = (left)->tv_sec + (right)->tv_sec;           \
        (sum)->tv_usec = (left)->tv_usec + (right)->tv_usec;        \
        if ((sum)->tv_usec >= 1000000) {                            \
            (sum)->tv_sec++;                                        \
            (sum)->tv_usec -= 1000000;                              \
        }                                                           \
    } while (0)
#define timersub(left, right, difference)                               \
    do {                                                                \
        (difference)->tv_sec = (left)->tv_sec - (right)->tv_sec;        \
        (difference)->tv_usec = (left)->tv_usec - (right)->tv_usec;     \
        if ((difference)->tv_usec < 0) {                                \
            (difference)->tv_sec--;                                     \
            (difference)->tv_usec += 1000000;                           \
        }                                                               \
    } while (0)

#endif
