/* The GPS receiver: one request, a position. */
#include <crs/device.h>

int crs_gps(int *x, int *y)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GPS, &message, 0, 0, 0, 0))
        return 0;
    *x = message.i[0];
    *y = message.i[1];
    return 1;
}
