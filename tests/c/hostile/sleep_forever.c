/* Sleeps for no time, for ever, and for times that are none. */
// ends: running
#include <crs_request.h>

int main(void)
{
    struct __crs_message message;
    double zero = 0, times[] = { 0, -1e300, zero / zero, 1e-300, 1 / zero, -1 / zero };
    unsigned i;

    for (i = 0;; i++) {
        message.f[0] = times[i % 6];
        __crs_request(CRS_SLEEP, &message);
    }
}
