/*
 * waypoints.c - drives to waypoints by GPS and compass.
 *
 * The receiver measures periodically, five times a second. The program reads the age of a
 * fix, and uses it in any case: at 10 in/s a fix of 0.2 s is 2 in old.
 *
 * Usage:  crs run waypoints.c gallery.xml
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define SPEED      100          /* 0.1 inch/s */
#define THERE      40           /* 0.1 inch */
#define PERIOD     200000       /* microseconds */
#define MAX_TURNS  300
#define PI         3.14159265358979

static const struct place {
    int x, y;                   /* 0.1 inch */
} way[] = { { 900, 400 }, { 2600, 1300 }, { 2300, 1900 } };

/* Returns the direction of a point relative to the robot's heading: -pi to pi. */
static double bearing(int dx, int dy)
{
    double angle;

    get_cp();
    angle = atan2(dy, dx) - State[STATE_COMPASS] * PI / 1800;
    return atan2(sin(angle), cos(angle));
}

static int drive_to(const struct place *goal)
{
    int turns, x, y, turn;
    double left;

    for (turns = 0; turns < MAX_TURNS; turns++, usleep(PERIOD)) {
        if (!crs_gps(&x, &y))
            continue;
        if (hypot(goal->x - x, goal->y - y) <= THERE) {
            printf("at %d, %d by a fix %d ms old\n", x, y, crs_age(CRS_SENSOR_GPS));
            return 1;
        }
        left = bearing(goal->x - x, goal->y - y);
        turn = (int)(80 * left);
        vm((fabs(left) < 0.5 ? SPEED : 0) + turn, (fabs(left) < 0.5 ? SPEED : 0) - turn, 0);
    }
    return 0;
}

int main(void)
{
    unsigned i;

    if (!connect_robot(1))
        return 1;
    for (i = 0; i < sizeof way / sizeof way[0]; i++)
        if (!drive_to(&way[i])) {
            printf("did not get to place %u\n", i);
            return 1;
        }
    st();
    ws(1, 1, 0, 10);
    disconnect_robot(1);
    return 0;
}
