/*
 * leader.c - drive a fixed course for another robot to follow: see follower.c.
 *
 * Its sonars stay off, so that they do not confuse those of the robot behind.
 *
 * Usage:  crs run convoy/convoy.xml          the world names the programs of both robots
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

struct leg {
    int trans, steer;          /* 0.1 inch/s, 0.1 degree/s */
    int seconds;
};

static const struct leg course[] = {
    { 60, 0, 12 }, { 50, 70, 6 }, { 60, 0, 4 }, { 50, -70, 12 }, { 60, 0, 3 },
    { 50, 70, 6 }, { 0, 0, 2 }, { 70, 0, 5 },
};

int main(void)
{
    static int none[16] = { 255 };
    unsigned i;
    int tenths;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    conf_tm(1);
    conf_sn(15, none);
    ac(100, 100, 0);
    dp(0, 0);
    da(0, 0);
    for (i = 0; i < sizeof course / sizeof *course; i++) {
        for (tenths = 0; tenths < 10 * course[i].seconds; tenths++) {
            scout_vm(course[i].trans, course[i].steer);
            usleep(80000);
        }
        printf("leg %u ends at (%.1f, %.1f)\n", i, State[STATE_CONF_X] / 10.0,
               State[STATE_CONF_Y] / 10.0);
    }
    st();
    ws(1, 1, 0, 5);
    disconnect_robot(1);
    return 0;
}
