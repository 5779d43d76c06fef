/* The sonars' modes, and their distances beyond the range of State. */
#include <crs/device.h>

#define SONARS 16

int crs_sonar_mode(int mode)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_SONAR_MODE, &message, mode, 0, 0, 0);
}

int crs_sonar(int *ranges, int most)
{
    struct __crs_message message;
    const int *heard = (const int *)message.data;
    int i;

    if (!__crs_ask_device(CRS_SONAR_RANGES, &message, 0, 0, 0, 0))
        return 0;
    for (i = 0; i < SONARS && i < most; i++)
        ranges[i] = heard[i];
    return i;
}
