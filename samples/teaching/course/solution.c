/*
 * solution.c - the course, driven by odometry.
 *
 * Usage:  crs run solution.c course.xml --summary
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

#define PI  3.14159265358979

/* The flags and home, from where the robot starts [0.1 inch]. */
static const struct place {
    const char *name;
    int x, y;
} way[] = { { "flag 1", 1340, 0 }, { "flag 2", 1500, 1180 }, { "flag 3", 80, 1180 },
            { "home", 0, 0 } };

/* Turns towards a place and drives there, as odometry has it. */
static void drive_to(const struct place *place)
{
    double dx, dy, turn;

    get_rc();
    dx = place->x - State[STATE_CONF_X];
    dy = place->y - State[STATE_CONF_Y];
    turn = remainder(atan2(dy, dx) - State[STATE_CONF_STEER] * PI / 1800, 2 * PI);
    scout_pr(0, (int)(turn * 1800 / PI));
    ws(1, 1, 0, 60);
    scout_pr((int)hypot(dx, dy), 0);
    ws(1, 1, 0, 60);
    get_rc();
    printf("%s: at %ld, %ld\n", place->name, State[STATE_CONF_X], State[STATE_CONF_Y]);
}

int main(void)
{
    unsigned i;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    conf_tm(0);
    ac(300, 300, 0);
    sp(250, 250, 0);
    for (i = 0; i < sizeof way / sizeof way[0]; i++)
        drive_to(&way[i]);
    st();
    ws(1, 1, 0, 10);
    sleep(3);
    disconnect_robot(1);
    return 0;
}
