/* The gripper: opening, closing, and its state. */
#include <crs/device.h>
#include <stddef.h>

int crs_gripper(int what)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_GRIPPER, &message, what, 0, 0, 0);
}

int crs_get_gripper(int *opening, int *beam, int *weight)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GET_GRIPPER, &message, 0, 0, 0, 0))
        return 0;
    if (opening != NULL)
        *opening = message.i[0];
    if (beam != NULL)
        *beam = message.i[1];
    if (weight != NULL)
        *weight = message.i[2];
    return 1;
}
