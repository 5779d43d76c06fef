/* C17 7.27: time. It is simulated time: a run starts on 1 January 2000 at 00:00:00 UTC. */
#ifndef _TIME_H
#define _TIME_H

#ifndef NULL
#define NULL ((void *)0)
#endif
#ifndef _SIZE_T
#define _SIZE_T
typedef unsigned int size_t;
#endif
#ifndef _TIME_T
#define _TIME_T
typedef long time_t;
#endif
#ifndef _CLOCK_T
#define _CLOCK_T
typedef long clock_t;
#endif

#define CLOCKS_PER_SEC 1000000L

#ifndef _STRUCT_TIMESPEC
#define _STRUCT_TIMESPEC
struct timespec {
    time_t tv_sec;
    long tv_nsec;
};
#endif

clock_t clock(void);
time_t time(time_t *now);
double difftime(time_t end, time_t start);
int nanosleep(const struct timespec *wanted, struct timespec *left);

#endif
