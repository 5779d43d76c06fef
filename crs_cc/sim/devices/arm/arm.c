/* The arm's joints, and the hand at its tip. */
#include <crs/device.h>
#include <stddef.h>

static int move(int by, int shoulder, int elbow)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_ARM, &message, by, shoulder, elbow, 0);
}

int crs_arm_move(int shoulder, int elbow)
{
    return move(0, shoulder, elbow);
}

int crs_arm_turn(int shoulder, int elbow)
{
    return move(1, shoulder, elbow);
}

int crs_arm_get(int *shoulder, int *elbow, int *x, int *y)
{
    struct __crs_message message;
    int *places[4] = { shoulder, elbow, x, y };
    int n;

    if (!__crs_ask_device(CRS_GET_ARM, &message, 0, 0, 0, 0))
        return 0;
    for (n = 0; n < 4; n++)
        if (places[n] != NULL)
            *places[n] = message.i[n];
    return 1;
}

int crs_hand(int what)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_HAND, &message, what, 0, 0, 0);
}

int crs_get_hand(int *weight)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_GET_ARM, &message, 0, 0, 0, 0))
        return 0;
    *weight = message.i[4];
    return 1;
}
