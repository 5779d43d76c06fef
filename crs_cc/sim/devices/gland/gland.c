/* The gland: deposits in pheromone fields. */
#include <crs/device.h>

static int deposit(int code, int field, double amount)
{
    struct __crs_message message;

    message.i[0] = field;
    message.f[0] = amount;
    message.size = 0;
    return __crs_post_device(code, &message);
}

int crs_deposit(int field, double amount)
{
    return deposit(CRS_DEPOSIT, field, amount);
}

int crs_lay_trail(int field, double amount)
{
    return deposit(CRS_LAY_TRAIL, field, amount);
}
