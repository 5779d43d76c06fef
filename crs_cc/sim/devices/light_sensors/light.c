/* The ring of light sensors. */
#include <crs/device.h>

int crs_get_light(int *readings, int most)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GET_LIGHT, &message, 0, 0, 0, 0))
        return 0;
    return __crs_take_data(&message, message.i[0], readings, most);
}
