/*
 * mow.c - covers the floor of a room in lanes, like a lawn mower.
 *
 * The robot drives to and fro. At the end of each lane it turns, drives the width of a
 * lane, and turns again. The goals of the world say how much of the floor counts.
 *
 * Usage:  crs run mow.c mowing.xml --summary
 */

#include <stdio.h>
#include "Nclient.h"

#define LANE     1320     /* length of a lane,           0.1 inch */
#define ASIDE    140      /* from one lane to the next,  0.1 inch */
#define LANES    7
#define QUARTER  900      /* a right angle,              0.1 degree */

static void go(int trans, int steer)
{
    scout_pr(trans, steer);
    ws(1, 1, 0, 60);
}

int main(void)
{
    int lane, turn;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    conf_tm(0);
    ac(400, 400, 0);
    sp(400, 400, 0);

    for (lane = 1; lane <= LANES; lane++) {
        go(LANE, 0);
        get_rc();
        printf("lane %d ends at x %ld, y %ld\n", lane,
               State[STATE_CONF_X] / 10, State[STATE_CONF_Y] / 10);
        if (lane == LANES)
            break;
        turn = lane % 2 ? QUARTER : -QUARTER;
        go(0, turn);
        go(ASIDE, 0);
        go(0, turn);
    }
    st();
    disconnect_robot(1);
    return 0;
}
