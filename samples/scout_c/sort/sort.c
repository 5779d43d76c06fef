/*
 * sort.c - collect cans and sort them by weight.
 *
 * Cans are somewhere on the line ahead. The robot drives until the beam between the
 * fingers of its gripper is interrupted, closes them, and so measures the width and the
 * weight of the can. It carries the can home, heavy ones to the left and light ones to
 * the right, puts it down and goes for the next.
 *
 * Usage:  crs run sort/sort.xml              the world names the program
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define CREEP     80         /* 0.1 inch/s, looking for cans */
#define FARTHEST  1700       /* 0.1 inch, from home */
#define HEAVY     1000       /* gram */
#define ROOM      120        /* 0.1 inch, from can to can */
#define PLACE     420        /* 0.1 inch, of the first can, from home */

#define SIDE      900        /* 0.1 degree */
#define AHEAD     0

static void drive(int way)
{
    pr(way, way, 0);
    ws(1, 1, 0, 60);
}

/* Turns in place to a direction, counter-clockwise from the front. */
static void face(int direction)
{
    int left = (direction - State[STATE_CONF_STEER]) % 3600;

    if (left > 1800)
        left -= 3600;
    if (left < -1800)
        left += 3600;
    left = left * 1186 / 10000;              /* 0.1186 inch per wheel and degree */
    pr(left, -left, 0);
    ws(1, 1, 0, 60);
}

/* Drives until an object is between the fingers; returns whether there is one. */
static int search(void)
{
    int beam = 0;

    vm(CREEP, CREEP, 0);
    while (!beam && State[STATE_CONF_X] < FARTHEST) {
        usleep(50000);
        gs();
        crs_get_gripper(NULL, &beam, NULL);
    }
    st();
    ws(1, 1, 0, 10);
    return beam;
}

int main(void)
{
    int count[2] = { 0, 0 }, way, width, weight, heavy;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    while (search()) {
        crs_gripper(CRS_CLOSE);
        sleep(2);
        crs_get_gripper(&width, NULL, &weight);
        if (weight == 0) {
            printf("it slipped away\n");
            break;
        }
        heavy = weight > HEAVY;
        printf("at %3d in: %d.%d in wide, %4d g, goes to the %s\n", State[STATE_CONF_X] / 10,
               width / 10, width % 10, weight, heavy ? "left" : "right");

        drive(-State[STATE_CONF_X]);
        face(heavy ? SIDE : -SIDE);
        way = PLACE - ROOM * count[heavy]++;
        drive(way);
        crs_gripper(CRS_OPEN);
        sleep(2);
        drive(-way);
        face(AHEAD);
    }
    printf("%d heavy, %d light\n", count[1], count[0]);
    disconnect_robot(1);
    return count[0] + count[1] == 4 ? 0 : 1;
}
