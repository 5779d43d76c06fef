/*
 * laser_door.c - finds a door in a wall by laser and drives through it.
 *
 * In a door, adjacent beams measure a much longer range than at its sides. The robot
 * drives up to the wall, locates the door, and drives through its centre.
 *
 * Usage:  crs run laser_door.c gallery.xml
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define BEAMS      181          /* 1 degree apart, from the right to the left */
#define AHEAD      90           /* the beam straight on */
#define FAR        2360         /* range used where nothing is in range, 0.1 inch */
#define STEP       300          /* minimum step in range at the sides of a door */
#define WIDEST     600          /* maximum width of a door, 0.1 inch */
#define FORWARD    60           /* position of the laser, forward, 0.1 inch */
#define TIMEOUT    60           /* seconds */
#define PI         3.14159265358979

static void turn(int angle)
{
    int way = (int)(angle * 0.118597);

    pr(way, -way, 0);
    ws(1, 1, 0, TIMEOUT);
}

static void go(int way)
{
    pr(way, way, 0);
    ws(1, 1, 0, TIMEOUT);
}

struct door {
    double x, y;                /* its centre, forward and left of the robot, 0.1 inch */
    double width;
};

/* Finds the door: a run of beams between two jumps. Returns 0 if there is none. */
static int find_door(const int *ranges, struct door *door)
{
    int i, first = -1;
    double ax, ay, bx, by, width;

    door->width = 0;
    for (i = 1; i < BEAMS; i++) {
        if (ranges[i] - ranges[i - 1] > STEP)
            first = i - 1;                       /* its right side */
        if (ranges[i - 1] - ranges[i] > STEP && first >= 0) {
            ax = ranges[first] * cos((first - AHEAD) * PI / 180);
            ay = ranges[first] * sin((first - AHEAD) * PI / 180);
            bx = ranges[i] * cos((i - AHEAD) * PI / 180);
            by = ranges[i] * sin((i - AHEAD) * PI / 180);
            width = hypot(bx - ax, by - ay);
            if (width > door->width && width < WIDEST && fabs(bx - ax) < width / 2) {
                door->width = width;
                door->x = (ax + bx) / 2 + FORWARD;
                door->y = (ay + by) / 2;
            }
            first = -1;
        }
    }
    return door->width > 0;
}

int main(void)
{
    int ranges[BEAMS], i;
    struct door door;

    if (!connect_robot(1))
        return 1;
    sp(150, 150, 0);
    turn(-250);                                  /* past the column */
    go(1000);
    turn(250);
    go(1100);
    if (crs_laser(ranges, BEAMS) != BEAMS)
        return 1;
    for (i = 0; i < BEAMS; i++)
        if (ranges[i] < 0)
            ranges[i] = FAR;
    printf("ahead %d in, right %d in, left %d in\n", ranges[AHEAD] / 10, ranges[0] / 10,
           ranges[BEAMS - 1] / 10);
    if (!find_door(ranges, &door)) {
        printf("no door\n");
        return 1;
    }
    printf("a door of %d in, %d in ahead and %d in to the left\n", (int)(door.width / 10),
           (int)(door.x / 10), (int)(door.y / 10));
    turn(900);
    go((int)door.y);
    turn(-900);
    go((int)door.x + 250);
    get_bp();
    printf("through it\n");
    disconnect_robot(1);
    return 0;
}
