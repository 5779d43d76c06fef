/*
 * two_modes.c - uses one sonar mode for long range, the other for short range.
 *
 * The low frequency detects a column across the hall, with a resolution of 10 cm; the
 * high one does not detect it from there, but measures millimetres nearby.
 *
 * Usage:  crs run two_modes.c gallery.xml
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define LF         0            /* the modes, in the order of the robot's definition */
#define HF         1
#define ROUND      1000000      /* time for all sonars to fire, microseconds */
#define BEFORE     400          /* distance at which to stop, 0.1 inch */
#define TIMEOUT    60           /* seconds */
#define LOOKS      10

/* Returns the range ahead in a mode: 0.1 inch, -1 for no echo. */
static int look(int mode)
{
    int ahead;

    crs_sonar_mode(mode);
    usleep(ROUND);
    crs_sonar(&ahead, 1);
    return ahead;
}

int main(void)
{
    int far, near, i, range, least, most;

    if (!connect_robot(1))
        return 1;
    far = look(LF);
    near = look(HF);
    printf("at first: LF %d, HF %d\n", far, near);
    if (far < 0)
        return 1;

    pr(far - BEFORE, far - BEFORE, 0);
    ws(1, 1, 0, TIMEOUT);

    printf("there: LF %d\n", look(LF));
    least = most = look(HF);
    for (i = 1; i < LOOKS; i++) {
        range = look(HF);
        if (range < least)
            least = range;
        if (range > most)
            most = range;
    }
    printf("there: HF %d to %d\n", least, most);
    disconnect_robot(1);
    return 0;
}
