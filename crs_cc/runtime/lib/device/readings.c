/* Readings that do not fit one reply are transferred in pages. */
#include <crs/device.h>

int __crs_take_readings(int sensor, int count, int *numbers, int most)
{
    struct __crs_message message;
    const int *page = (const int *)message.data;
    int size, reading = 0, i;

    if (count > most)
        count = most;
    while (reading < count) {
        size = __crs_ask_device(CRS_READINGS, &message, sensor, reading, 0, 0);
        if (size <= 0)
            break;
        if (size > count - reading)
            size = count - reading;
        for (i = 0; i < size * message.i[0]; i++)
            *numbers++ = page[i];
        reading += size;
    }
    return reading;
}
