/* The inclinometer: one request, two angles. */
#include <crs/device.h>

int crs_tilt(int *pitch, int *roll)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_TILT, &message, 0, 0, 0, 0))
        return 0;
    *pitch = message.i[0];
    *roll = message.i[1];
    return 1;
}
