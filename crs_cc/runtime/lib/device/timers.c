/* Periodic sensors: their periods, and the age of readings. */
#include <crs/device.h>

int crs_period(int sensor, int ms)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_PERIOD, &message, sensor, ms, 0, 0);
}

int crs_age(int sensor)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_AGE, &message, sensor, 0, 0, 0) ? message.i[0] : -1;
}
