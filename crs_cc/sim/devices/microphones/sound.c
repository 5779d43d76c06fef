/* The microphones. */
#include <crs/device.h>
#include <stddef.h>

#define TONES 8

int crs_get_sound(int *levels, int most, int *direction)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GET_SOUND, &message, 0, 0, 0, 0))
        return 0;
    if (direction != NULL)
        *direction = message.i[0];
    return __crs_take_data(&message, TONES, levels, most);
}
