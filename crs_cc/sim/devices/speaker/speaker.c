/* The robot's speaker. */
#include <crs/device.h>

int crs_sound(int level, int tone)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_SOUND, &message, level, tone, 0, 0);
}
