/* The antennae: smelling pheromone fields. */
#include <crs/device.h>

double crs_smell(int field, int antenna)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_SMELL, &message, field, antenna, 0, 0) ? message.f[0] : -1.0;
}

int crs_smell_gradient(int field, double *ahead, double *left)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_SMELL, &message, field, 0, 1, 0))
        return 0;
    *ahead = message.f[1];
    *left = message.f[2];
    return 1;
}
