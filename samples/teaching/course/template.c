/*
 * template.c - drives the course; write your name here
 *
 * Drive the Scout to the three flags in any order, then home, without a collision.
 * The floor is 6 m by 5 m; the robot starts at x = 1 m, y = 1 m, and faces along x.
 * The flags are at (4.4 m, 1 m), (4.8 m, 4 m) and (1.2 m, 4 m); a box of 1.6 m by 1 m
 * is in the middle of the room, and a pillar at (5.2 m, 1 m).
 *
 * Try it:  crs run template.c course.xml --summary --plot course.svg
 */

#include <stdio.h>
#include "Nclient.h"

/* Drives a distance [0.1 inch], then turns by an angle [0.1 degree, left is positive]. */
static void go(int distance, int angle)
{
    scout_pr(distance, 0);
    ws(1, 1, 0, 60);
    scout_pr(0, angle);
    ws(1, 1, 0, 60);
}

int main(void)
{
    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    conf_tm(0);                 /* no timeout of commands */
    ac(200, 200, 0);            /* 0.1 inch/s/s */
    sp(150, 150, 0);            /* 0.1 inch/s */

    go(400, 0);                 /* TODO: about a metre; the rest is yours */

    disconnect_robot(1);
    return 0;
}
