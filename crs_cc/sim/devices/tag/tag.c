/* The tag actuator; its reply distinguishes a robot without one from one that found nothing. */
#include <crs/device.h>

int crs_tag(void)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_TAKE_HEAT, &message, 0, 0, 0, 0))
        return -1;
    return message.i[0];
}
