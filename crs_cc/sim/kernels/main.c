/* Serves calls of kernels: waits for one in a request, as robots' programs wait for replies. */
#include <crs_request.h>

#include "kernels.h"

static int arguments[2];
static double arena[3][2 * BLOCK];

int __crs_start(void)
{
    static struct __crs_message message;
    int *n = arguments;

    message.i[0] = (int)arguments;
    message.i[1] = (int)arena;
    for (;;) {
        __crs_request(1, &message);
        __crs_apply(n[0], n[1], arena[0], arena[1], arena[2]);
    }
}
