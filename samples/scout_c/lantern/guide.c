/*
 * guide.c - carries a light around a corner for another robot to follow.
 *
 * The lamp is on while the robot drives, and goes out when it has arrived.
 *
 * Usage:  crs run lantern/lantern.xml        the world names both programs
 */

#include <stdio.h>
#include "Nclient.h"
#include "crs.h"

#define LIGHT      400
#define QUARTER    107       /* wheel distance for 90 degrees: 0.1 inch */

static void leg(int right, int left)
{
    pr(right, left, 0);
    ws(1, 1, 0, 60);
}

int main(void)
{
    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    if (!crs_light(LIGHT)) {
        printf("no lamp\n");
        return 1;
    }
    sp(60, 60, 0);
    leg(1200, 1200);
    leg(QUARTER, -QUARTER);
    leg(1000, 1000);
    crs_light(0);
    printf("arrived at %d, %d in, the light is out\n", (int)State[STATE_CONF_X] / 10,
           (int)State[STATE_CONF_Y] / 10);
    return 0;
}
