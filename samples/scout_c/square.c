/*
 * square.c - drive a Scout around a square and print its odometry.
 *
 * The robot drives one side, turns left by 90 degrees, and so on, four times.
 * pr() only starts a move and ws() waits for its end, so that a pair of them
 * makes one leg. At each corner the odometry is printed. After the fourth turn
 * the robot should stand where it began: what is missing is the error of
 * closure, printed last.
 *
 * Usage:  crs run square.c              needs 1 m of free floor ahead and to the left
 *         crs run square.c room.xml
 */

#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define SIDE       400    /* length of a side,     0.1 inch */
#define CORNER     900    /* turn at each corner,  0.1 degree */
#define SPEED      100    /* speed of each wheel,  0.1 inch/s */
#define ACCEL      200    /* and its acceleration, 0.1 inch/s/s */

/* Starts a move by (trans, steer) and waits until both wheels have stopped. */
static void go(int trans, int steer)
{
    scout_pr(trans, steer);
    ws(1, 1, 0, 60);
}

static void print_pose(const char *where)
{
    get_rc();
    printf("%-10s x %7.1f in   y %7.1f in   heading %5.1f deg\n", where,
           State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0,
           State[STATE_CONF_STEER] / 10.0);
}

int main(void)
{
    char where[20];
    int corner;
    double dx, dy;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "square: no robot\n");
        return 1;
    }
    conf_tm(5);
    ac(ACCEL, ACCEL, 0);
    sp(SPEED, SPEED, 0);
    dp(0, 0);
    da(0, 0);

    print_pose("start");
    for (corner = 1; corner <= 4; corner++) {
        go(SIDE, 0);
        sprintf(where, "corner %d", corner);
        print_pose(where);
        go(0, CORNER);
    }
    print_pose("end");

    dx = State[STATE_CONF_X] / 10.0;
    dy = State[STATE_CONF_Y] / 10.0;
    printf("error of closure %.1f in\n", sqrt(dx * dx + dy * dy));

    st();
    disconnect_robot(ROBOT_ID);
    return 0;
}
