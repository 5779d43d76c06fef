/* The heat sensor: one request, a number. */
#include <crs/device.h>

int crs_heat(int *heat)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_SENSE_HEAT, &message, 0, 0, 0, 0))
        return 0;
    *heat = message.i[0];
    return 1;
}
