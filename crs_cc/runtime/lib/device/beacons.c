/* Light and sound: the robot's own, and what it senses of others'. */
#include <crs/device.h>
#include <stddef.h>
#include <string.h>

#define TONES 8

static int take(struct __crs_message *message, int have, int *numbers, int most)
{
    if (most < have)
        have = most < 0 ? 0 : most;
    memcpy(numbers, message->data, have * sizeof(int));
    return have;
}

int crs_light(int brightness)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_LIGHT, &message, brightness, 0, 0, 0);
}

int crs_sound(int level, int tone)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_SOUND, &message, level, tone, 0, 0);
}

int crs_get_light(int *readings, int most)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GET_LIGHT, &message, 0, 0, 0, 0))
        return 0;
    return take(&message, message.i[0], readings, most);
}

int crs_get_sound(int *levels, int most, int *direction)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GET_SOUND, &message, 0, 0, 0, 0))
        return 0;
    if (direction != NULL)
        *direction = message.i[0];
    return take(&message, TONES, levels, most);
}
