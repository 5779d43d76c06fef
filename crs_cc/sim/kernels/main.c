/* Serves calls of kernels: waits for one in a request, as robots' programs wait for replies. */
#include <crs_request.h>

#include "kernels.h"
#include "robot.h"

/* Other numbers are those of elementwise functions. */
enum { ECHOES = 100, RAYS, PROFILES, COUNTS, ADVANCE, REPORTS, COVERS, RENEW };

static int arguments[10];
static double arena[3][2 * BLOCK];
static struct robot robots[ROBOTS];
static struct drive drives[ROBOTS];

/* Return the rows of some robots, which follow a number for each and one for all. */
static const long long *rows(int count, int is_selection)
{
    return is_selection ? (const long long *)(arena[0] + 1 + count) : 0;
}

int __crs_start(void)
{
    static struct __crs_message message;
    int *n = arguments;

    message.i[0] = (int)arguments;
    message.i[1] = (int)arena;
    message.i[2] = (int)robots;
    message.i[3] = (int)drives;
    for (;;) {
        __crs_request(1, &message);
        if (n[0] == ECHOES)
            __crs_echoes(n[1], n[2], arena[0], arena[0] + n[3], arena[0] + n[4], arena[0] + n[5],
                         arena[0] + n[6]);
        else if (n[0] == RAYS)
            __crs_rays(n[1], n[2], n[3], n[4], n[5], arena[0], arena[0] + n[6], arena[0] + n[7],
                       arena[0] + n[8]);
        else if (n[0] == COVERS)
            __crs_covers(n[1], n[2], n[4], arena[0], arena[0] + n[6], arena[0] + n[7],
                         arena[0] + n[8]);
        else if (n[0] == PROFILES)
            __crs_profiles(n[1], arena[0]);
        else if (n[0] == COUNTS)
            __crs_counts(n[1], arena[0]);
        else if (n[0] == ADVANCE || n[0] == RENEW)
            n[0] = __crs_advance(n[1], n[0] == RENEW, rows(n[1], n[2]), arena[0][0], arena[0] + 1,
                                 drives, robots);
        else if (n[0] == REPORTS)
            __crs_reports(n[1], rows(n[1], n[2]), drives, robots, (int *)arena[1]);
        else
            __crs_apply(n[0], n[1], arena[0], arena[1], arena[2]);
    }
}
