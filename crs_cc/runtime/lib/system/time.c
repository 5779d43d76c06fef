/* Reading the time and waiting (C17 7.27.2; gettimeofday, clock_gettime, nanosleep, sleep, usleep,
   times: POSIX; ftime: 4.3BSD). */
#include <errno.h>
#include <sys/time.h>
#include <sys/timeb.h>
#include <sys/times.h>
#include <time.h>
#include <unistd.h>

#include <crs/clock.h>

/* The clock's microsecond: a time such as 0.3 s, as a double slightly less, counts as reached. */
static long long microseconds_of(double seconds)
{
    return (long long)(seconds * 1e6 + 1e-3);
}

time_t time(time_t *now)
{
    time_t result = CRS_START + (time_t)(microseconds_of(__crs_now(NULL)) / 1000000);

    if (__crs_after_request != NULL)
        __crs_after_request();
    if (now != NULL)
        *now = result;
    return result;
}

int gettimeofday(struct timeval *now, void *zone)
{
    long long microseconds = microseconds_of(__crs_now(NULL));

    if (__crs_after_request != NULL)
        __crs_after_request();
    if (now != NULL) {
        now->tv_sec = CRS_START + (time_t)(microseconds / 1000000);
        now->tv_usec = microseconds % 1000000;
    }
    if (zone != NULL) {
        ((struct timezone *)zone)->tz_minuteswest = 0;
        ((struct timezone *)zone)->tz_dsttime = 0;
    }
    return 0;
}

int ftime(struct timeb *now)
{
    long long microseconds = microseconds_of(__crs_now(NULL));

    if (__crs_after_request != NULL)
        __crs_after_request();
    now->time = CRS_START + (time_t)(microseconds / 1000000);
    now->millitm = microseconds / 1000 % 1000;
    now->timezone = now->dstflag = 0;
    return 0;
}

/* Only a superuser may set the clock, and nobody may set the simulator's. */
int settimeofday(const struct timeval *now, const struct timezone *zone)
{
    (void)now;
    (void)zone;
    errno = EPERM;
    return -1;
}

int clock_gettime(clockid_t clock, struct timespec *now)
{
    double processor_s, now_s = __crs_now(&processor_s);
    long long microseconds;

    if (clock == CLOCK_PROCESS_CPUTIME_ID || clock == CLOCK_THREAD_CPUTIME_ID)
        now_s = processor_s;
    else if (clock != CLOCK_REALTIME && clock != CLOCK_MONOTONIC) {
        errno = EINVAL;
        return -1;
    }
    microseconds = microseconds_of(now_s);
    now->tv_sec = microseconds / 1000000 + (clock == CLOCK_REALTIME ? CRS_START : 0);
    now->tv_nsec = microseconds % 1000000 * 1000;
    return 0;
}

int clock_getres(clockid_t clock, struct timespec *resolution)
{
    if (clock < CLOCK_REALTIME || clock > CLOCK_THREAD_CPUTIME_ID) {
        errno = EINVAL;
        return -1;
    }
    if (resolution != NULL) {
        resolution->tv_sec = 0;
        resolution->tv_nsec = 1000;
    }
    return 0;
}

int timespec_get(struct timespec *now, int base)
{
    long long microseconds = microseconds_of(__crs_now(NULL));

    if (base != TIME_UTC)
        return 0;
    now->tv_sec = CRS_START + microseconds / 1000000;
    now->tv_nsec = microseconds % 1000000 * 1000;
    return base;
}

/* Processor time in microseconds; like Linux's on 32 bits it wraps round after 71 minutes. */
clock_t clock(void)
{
    double processor_s;

    __crs_now(&processor_s);
    return (clock_t)(unsigned int)microseconds_of(processor_s);
}

/* Ticks of 1/100 s. */
clock_t times(struct tms *used)
{
    double processor_s, now_s = __crs_now(&processor_s);

    if (used != NULL) {
        used->tms_utime = (clock_t)(microseconds_of(processor_s) / 10000);
        used->tms_stime = used->tms_cutime = used->tms_cstime = 0;
    }
    return (clock_t)(microseconds_of(now_s) / 10000);
}

double difftime(time_t end, time_t start)
{
    return (double)end - (double)start;
}

int nanosleep(const struct timespec *wanted, struct timespec *left)
{
    double left_s;

    if (wanted->tv_sec < 0 || wanted->tv_nsec < 0 || wanted->tv_nsec >= 1000000000L) {
        errno = EINVAL;
        return -1;
    }
    left_s = __crs_pass(wanted->tv_sec + wanted->tv_nsec * 1e-9);
    if (left != NULL) {
        left->tv_sec = (time_t)left_s;
        left->tv_nsec = (long)((left_s - left->tv_sec) * 1e9);
    }
    if (left_s == 0)
        return 0;
    errno = EINTR;
    return -1;
}

int usleep(useconds_t microseconds)
{
    if (__crs_pass(microseconds * 1e-6) == 0)
        return 0;
    errno = EINTR;
    return -1;
}

/* Returns the remaining seconds if an alarm was delivered before. */
unsigned int sleep(unsigned int seconds)
{
    return (unsigned int)(__crs_pass(seconds) + 0.5);
}
