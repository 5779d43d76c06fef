/* Serves calls of kernels: waits for one in a request, as robots' programs wait for replies. */
#include <crs_request.h>

#include "kernels.h"

enum { ECHOES = 100, RAYS, PROFILES, COUNTS, MOVES, REPORTS };       /* other numbers are those of elementwise functions */

static int arguments[10];
static double arena[3][2 * BLOCK];

int __crs_start(void)
{
    static struct __crs_message message;
    int *n = arguments;

    message.i[0] = (int)arguments;
    message.i[1] = (int)arena;
    for (;;) {
        __crs_request(1, &message);
        if (n[0] == ECHOES)
            __crs_echoes(n[1], n[2], arena[0], arena[0] + n[3], arena[0] + n[4], arena[0] + n[5],
                         arena[0] + n[6]);
        else if (n[0] == RAYS)
            __crs_rays(n[1], n[2], n[3], n[4], n[5], arena[0], arena[0] + n[6], arena[0] + n[7],
                       arena[0] + n[8]);
        else if (n[0] == PROFILES)
            __crs_profiles(n[1], arena[0]);
        else if (n[0] == COUNTS)
            __crs_counts(n[1], arena[0]);
        else if (n[0] == MOVES)
            __crs_moves(n[1], arena[0]);
        else if (n[0] == REPORTS)
            __crs_reports(n[1], arena[0], (int *)arena[1]);
        else
            __crs_apply(n[0], n[1], arena[0], arena[1], arena[2]);
    }
}
