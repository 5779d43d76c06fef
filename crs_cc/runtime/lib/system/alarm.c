/* Alarms (POSIX alarm, setitimer, pause): a due SIGALRM is delivered when the library waits,
   reads the clock, or has called the robot. */
#include <errno.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <crs/clock.h>
#include <crs/signals.h>

static double interval_s;
static int delivered;     /* number of alarms delivered */

static void deliver(void)
{
    double now_s;

    if (__crs_alarm_s == __builtin_inf() || (now_s = __crs_now(NULL)) < __crs_alarm_s)
        return;
    __crs_alarm_s = interval_s > 0 ? __crs_alarm_s + interval_s : __builtin_inf();
    if (__crs_alarm_s < now_s)
        __crs_alarm_s = now_s;    /* several that are due are one, as on Linux */
    delivered++;
    __crs_signal(SIGALRM);
}

/* Sets the alarm and returns the remaining seconds of the previous one, 0 for none. */
static double set(double first_s, double next_s)
{
    double now_s = __crs_now(NULL), left_s = 0;

    if (__crs_alarm_s != __builtin_inf())
        left_s = __crs_alarm_s > now_s ? __crs_alarm_s - now_s : 1e-6;
    __crs_after_request = deliver;
    __crs_alarm_s = first_s > 0 ? now_s + first_s : __builtin_inf();
    interval_s = next_s;
    return left_s;
}

unsigned int alarm(unsigned int seconds)
{
    double left_s = set(seconds, 0);
    unsigned int whole = (unsigned int)(left_s + 0.5);

    return left_s > 0 && whole == 0 ? 1 : whole;
}

unsigned int ualarm(unsigned int first, unsigned int interval)
{
    return (unsigned int)(set(first * 1e-6, interval * 1e-6) * 1e6);
}

static double seconds_of(const struct timeval *time)
{
    return time->tv_sec + time->tv_usec * 1e-6;
}

static struct timeval timeval_of(double seconds)
{
    struct timeval time;
    long long microseconds = (long long)(seconds * 1e6 + 0.5);

    time.tv_sec = microseconds / 1000000;
    time.tv_usec = microseconds % 1000000;
    return time;
}

static int is_real(int which)
{
    if (which == ITIMER_REAL)
        return 1;
    errno = EINVAL;
    return 0;
}

int setitimer(int which, const struct itimerval *wanted, struct itimerval *before)
{
    double interval_before_s = interval_s, left_s;

    if (!is_real(which))
        return -1;
    left_s = set(seconds_of(&wanted->it_value), seconds_of(&wanted->it_interval));
    if (before != NULL) {
        before->it_value = timeval_of(left_s);
        before->it_interval = timeval_of(interval_before_s);
    }
    return 0;
}

int getitimer(int which, struct itimerval *now)
{
    if (!is_real(which))
        return -1;
    now->it_value = timeval_of(
        __crs_alarm_s == __builtin_inf() ? 0 : __crs_alarm_s - __crs_now(NULL));
    now->it_interval = timeval_of(interval_s);
    return 0;
}

/* There are no other signals, so without an alarm the wait does not end. */
void __crs_await_signal(unsigned long mask)
{
    int before = delivered;

    while (delivered == before || mask & sigmask(SIGALRM))
        __crs_pass(1e9);
}

int pause(void)
{
    __crs_await_signal(0);
    errno = EINTR;
    return -1;
}
