/* Simulated time: reading the clock, and waiting. */
#include <crs_request.h>

#include <crs/clock.h>

double __crs_alarm_s = __builtin_inf();
void (*__crs_after_request)(void);

double __crs_now(double *processor_s)
{
    struct __crs_message message;

    __crs_request(CRS_CLOCK, &message);
    if (processor_s != 0)
        *processor_s = message.f[1];
    return message.f[0];
}

static void sleep_s(double seconds)
{
    struct __crs_message message;

    message.f[0] = seconds;
    __crs_request(CRS_SLEEP, &message);
}

double __crs_pass(double seconds)
{
    double until_s;

    if (__crs_after_request == 0) {
        sleep_s(seconds);
        return 0;
    }
    __crs_after_request();
    until_s = __crs_now(0) + seconds;
    if (__crs_alarm_s >= until_s) {
        sleep_s(seconds);
        return 0;
    }
    sleep_s(__crs_alarm_s - (until_s - seconds));
    __crs_after_request();
    seconds = until_s - __crs_now(0);
    return seconds > 0 ? seconds : 0;
}
