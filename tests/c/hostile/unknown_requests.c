/* Request codes that nobody serves, with messages full of anything. */
// ends: exit 0
#include <crs_request.h>
#include <string.h>

int main(void)
{
    struct __crs_message message;
    unsigned seed = 1, i, n;

    for (n = 0; n < 3000; n++) {
        unsigned char *p = (unsigned char *) &message;
        for (i = 0; i < sizeof message; i++)
            p[i] = (seed = seed * 1664525u + 1013904223u) >> 24;
        seed = seed * 1664525u + 1013904223u;
        i = seed >> (seed & 31);
        if (i != CRS_EXIT)
            __crs_request((int) i, &message);
    }
    return 0;
}
