/* The carrier: taking items from sources, and dropping them in nests. */
#include <crs/device.h>

static int ask(int code, struct __crs_message *message)
{
    return __crs_ask_device(code, message, 0, 0, 0, 0);
}

int crs_take(void)
{
    struct __crs_message message;

    return ask(CRS_TAKE_ITEM, &message);
}

int crs_drop(void)
{
    struct __crs_message message;

    return ask(CRS_DROP_ITEM, &message);
}

int crs_items(void)
{
    struct __crs_message message;

    return ask(CRS_ITEMS, &message) ? message.i[0] : -1;
}
