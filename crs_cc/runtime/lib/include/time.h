/* C17 7.27: time. It is simulated time: a run starts on 1 January 2000 at 00:00:00 UTC, and local
   time is UTC. */
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
typedef int clockid_t;

#define CLOCKS_PER_SEC 1000000L
#define CLK_TCK 100
#define TIME_UTC 1

#define CLOCK_REALTIME 0
#define CLOCK_MONOTONIC 1
#define CLOCK_PROCESS_CPUTIME_ID 2
#define CLOCK_THREAD_CPUTIME_ID 3

#ifndef _STRUCT_TIMESPEC
#define _STRUCT_TIMESPEC
struct timespec {
    time_t tv_sec;
    long tv_nsec;
};
#endif

struct tm {
    int tm_sec, tm_min, tm_hour;
    int tm_mday, tm_mon, tm_year;   /* 1 to 31, 0 to 11, since 1900 */
    int tm_wday, tm_yday;           /* since Sunday, since 1 January */
    int tm_isdst;
    long tm_gmtoff;
    const char *tm_zone;
};

clock_t clock(void);
time_t time(time_t *now);
double difftime(time_t end, time_t start);
time_t mktime(struct tm *date);
time_t timegm(struct tm *date);
int timespec_get(struct timespec *now, int base);
struct tm *gmtime(const time_t *time);
struct tm *localtime(const time_t *time);
struct tm *gmtime_r(const time_t *time, struct tm *date);
struct tm *localtime_r(const time_t *time, struct tm *date);
char *asctime(const struct tm *date);
char *asctime_r(const struct tm *date, char *text);
char *ctime(const time_t *time);
char *ctime_r(const time_t *time, char *text);
size_t strftime(char *text, size_t size, const char *format, const struct tm *date);
char *strptime(const char *text, const char *format, struct tm *date);
int nanosleep(const struct timespec *wanted, struct timespec *left);
int clock_gettime(clockid_t clock, struct timespec *now);
int clock_getres(clockid_t clock, struct timespec *resolution);
void tzset(void);

extern char *tzname[2];
extern long timezone;
extern int daylight;

#endif
