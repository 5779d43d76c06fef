/* Numbers and names of robots, channels and fields. */
#include <crs/device.h>
#include <stddef.h>
#include <string.h>

/* Looks up a name; returns the number, -1 for none. */
static int find(int code, const char *name)
{
    struct __crs_message message;
    size_t size = name != NULL ? strlen(name) : 0;

    if (size == 0 || size > CRS_DATA_SIZE)
        return -1;
    message.i[0] = 0;
    message.size = (int)size;
    memcpy(message.data, name, size);
    return __crs_post_device(code, &message) ? message.i[0] : -1;
}

int crs_find_channel(const char *name)
{
    return find(CRS_CHANNEL, name);
}

int crs_find_field(const char *name)
{
    return find(CRS_FIELD, name);
}

int crs_find_robot(const char *name)
{
    return find(CRS_ROBOT, name);
}

int crs_my_number(void)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_ROBOT, &message, -1, 0, 0, 0) ? message.i[0] : -1;
}

int crs_robot_count(void)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_ROBOT, &message, -1, 0, 0, 0) ? message.i[1] : 0;
}

int crs_robot_name(int number, char *name, int size)
{
    struct __crs_message message;
    int length;

    if (number < 0 || size <= 0 || !__crs_ask_device(CRS_ROBOT, &message, number, 0, 0, 0))
        return 0;
    length = message.size < size ? message.size : size - 1;
    memcpy(name, message.data, length);
    name[length] = '\0';
    return 1;
}
