/*
 * aisle.c - drives down an aisle, and steers away from obstacles at its sides.
 *
 * The sonars are numbered against the clock: 0 looks ahead, 1 to 4 look to the left, and
 * those that mirror them to the right. The nearer something is at a side, the harder the
 * robot steers away from it.
 *
 * Usage:  crs run aisle.c aisle.xml
 */

#include <stdio.h>
#include "Nclient.h"

#define ROBOT_ID    1
#define N_SONARS    16
#define NO_ECHO     255
#define SIDE        4          /* sonars on each side */

#define LENGTH      2200       /* of the aisle, 0.1 inch */
#define SIDE_DIST   20         /* distance to keep, inches */
#define SPEED       80         /* 0.1 inch/s */
#define GAIN        12         /* 0.1 degree/s per inch below SIDE_DIST */
#define MAX_STEPS   1500

static struct {
    long left, right;          /* the nearest echo, inches */
} view;

/* Reads the sonars, and finds the nearest echo on each side. */
static void look(void)
{
    long *sonar = &State[STATE_SONAR_0];
    int i, mirror;

    get_sn();
    view.left = view.right = NO_ECHO;
    for (i = 1; i <= SIDE; i++) {
        mirror = N_SONARS - 1 - i;
        if (sonar[i] < view.left)
            view.left = sonar[i];
        if (sonar[mirror] < view.right)
            view.right = sonar[mirror];
    }
}

/* Returns by how much a distance is below SIDE_DIST, inches. */
static int too_near(long distance)
{
    return distance < SIDE_DIST ? (int) (SIDE_DIST - distance) : 0;
}

/* Returns the heading relative to the start, 0.1 degree. */
static int turned(void)
{
    int angle = (int) State[STATE_CONF_STEER];

    return angle > 1800 ? angle - 3600 : angle;
}

static void drive(void)
{
    int turn = GAIN * (too_near(view.right) - too_near(view.left));

    scout_vm(SPEED, turn - 2 * turned());
}

int main(void)
{
    int step;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "aisle: no robot\n");
        return 1;
    }
    conf_tm(5);
    ac(300, 300, 0);
    dp(0, 0);
    da(0, 0);
    look();
    for (step = 0; step < MAX_STEPS && State[STATE_CONF_X] < LENGTH; step++) {
        drive();
        look();
    }
    st();
    ws(1, 1, 0, 5);
    get_rc();
    printf("stopped after %d steps, %.0f in down the aisle\n", step, State[STATE_CONF_X] / 10.0);
    disconnect_robot(ROBOT_ID);
    return 0;
}
