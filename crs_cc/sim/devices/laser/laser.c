/* The laser's distances, direction by direction. */
#include <crs/device.h>

int crs_laser(int *ranges, int most)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_LASER, &message, 0, 0, 0, 0))
        return 0;
    return __crs_take_readings(CRS_SENSOR_LASER, message.i[0], ranges, most);
}
