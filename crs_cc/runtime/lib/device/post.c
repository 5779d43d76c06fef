/* Requests to devices of crs.h need no connection; afterwards signals are delivered, as after any
   call of the robot. */
#include <crs/clock.h>
#include <crs/device.h>
#include <stddef.h>
#include <string.h>

int __crs_post_device(int code, struct __crs_message *message)
{
    int result = __crs_request(code, message);

    if (__crs_after_request != NULL)
        __crs_after_request();
    return result;
}

int __crs_ask_device(int code, struct __crs_message *message, int a, int b, int c, int d)
{
    message->i[0] = a;
    message->i[1] = b;
    message->i[2] = c;
    message->i[3] = d;
    message->size = 0;
    return __crs_post_device(code, message);
}

int __crs_take_data(const struct __crs_message *message, int have, int *numbers, int most)
{
    if (most < have)
        have = most < 0 ? 0 : most;
    memcpy(numbers, message->data, have * sizeof(int));
    return have;
}
