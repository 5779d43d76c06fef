/* The robot's lamp. */
#include <crs/device.h>

int crs_light(int brightness)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_LIGHT, &message, brightness, 0, 0, 0);
}
