/* Simulated time (C17 7.27.2; gettimeofday, nanosleep, sleep, usleep: POSIX). */
#include <crs_request.h>
#include <errno.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#define EPOCH_S 946684800L   /* when a run starts: 1 January 2000, 00:00:00 UTC, in Unix time */

/* Gives seconds since the start of the run. */
static double now_s(void)
{
    struct __crs_message message;

    __crs_request(CRS_CLOCK, &message);
    return message.f[0];
}

static void pass_s(double seconds)
{
    struct __crs_message message;

    message.f[0] = seconds;
    __crs_request(CRS_SLEEP, &message);
}

time_t time(time_t *now)
{
    time_t result = EPOCH_S + (time_t)now_s();

    if (now != NULL)
        *now = result;
    return result;
}

/* The clock's microsecond: a time such as 0.3 s, as a double slightly less, counts as reached. */
int gettimeofday(struct timeval *now, void *zone)
{
    long long microseconds = (long long)(now_s() * 1e6 + 1e-3);

    if (now != NULL) {
        now->tv_sec = EPOCH_S + (time_t)(microseconds / 1000000);
        now->tv_usec = microseconds % 1000000;
    }
    if (zone != NULL) {
        ((struct timezone *)zone)->tz_minuteswest = 0;
        ((struct timezone *)zone)->tz_dsttime = 0;
    }
    return 0;
}

/* Processor time in microseconds; like Linux's on 32 bits it wraps round after 71 minutes. */
clock_t clock(void)
{
    struct __crs_message message;

    __crs_request(CRS_CLOCK, &message);
    return (clock_t)(unsigned int)(long long)(message.f[1] * 1e6 + 1e-3);
}

double difftime(time_t end, time_t start)
{
    return (double)end - (double)start;
}

int nanosleep(const struct timespec *wanted, struct timespec *left)
{
    if (wanted->tv_sec < 0 || wanted->tv_nsec < 0 || wanted->tv_nsec >= 1000000000L) {
        errno = EINVAL;
        return -1;
    }
    pass_s(wanted->tv_sec + wanted->tv_nsec * 1e-9);
    if (left != NULL)
        left->tv_sec = left->tv_nsec = 0;
    return 0;
}

int usleep(useconds_t microseconds)
{
    pass_s(microseconds * 1e-6);
    return 0;
}

unsigned int sleep(unsigned int seconds)
{
    pass_s(seconds);
    return 0;
}
