/*
 * turret.c - a Nomad 200 drives around a pillar with its turret facing it.
 *
 * The three axes of a Nomad 200 are independent: its wheels drive, all of them are
 * steered together, and the turret with the sonars rotates above them. The base itself
 * never turns. So the robot can face one side all the time while it drives a course with
 * corners.
 *
 * The position of the pillar is known; its direction follows from the encoders, and the
 * turret is held there. Sonar 0, which points where the turret points, should then read
 * the distance to the pillar, minus the two radii. Both are printed, and at the end their
 * difference.
 *
 * Usage:  crs run turret.c pillar.xml
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID    1
#define SHELL       9.0          /* radius of the turret, inches */
#define PILLAR_X    70.0         /* from the start, inches */
#define PILLAR_Y    50.0
#define PILLAR_R    6.0
#define SPEED       80           /* 0.1 inch/s */
#define NEAR        3.0          /* tolerance at corners of the course, inches */
#define STEER_RATE  450          /* 0.1 degree/s */
#define MAX_TURNS   1500

static const struct { double x, y; } course[] = {
    { 140, 0 }, { 140, 100 }, { 0, 100 }, { 0, 0 },
};

static int order[16] = { 0, 1, 15, 255 };

static double x(void) { return State[STATE_CONF_X] / 10.0; }
static double y(void) { return State[STATE_CONF_Y] / 10.0; }

/* Returns the turn from an encoder direction, in 0.1 degree, to a point, degrees. */
static double bearing(long from, double to_x, double to_y)
{
    double degrees = atan2(to_y - y(), to_x - x()) * 180.0 / M_PI;

    return remainder(degrees - from / 10.0, 360.0);
}

static int rate(double degrees)
{
    double tenths = 20.0 * degrees;

    return (int) (tenths > STEER_RATE ? STEER_RATE : tenths < -STEER_RATE ? -STEER_RATE : tenths);
}

/* Turns the wheels and the turret in place, and waits for both. */
static void aim(double to_x, double to_y)
{
    double wheels = bearing(State[STATE_CONF_STEER], to_x, to_y);
    double turret = bearing(State[STATE_CONF_TURRET], PILLAR_X, PILLAR_Y);

    pr(0, (int) (10.0 * wheels), (int) (10.0 * turret));
    ws(0, 1, 1, 20);
    gs();
}

int main(void)
{
    double expected, off, sum = 0.0, worst = 0.0, aside;
    int turns = 0, corner, looks = 0, trans;

    if (!connect_robot(ROBOT_ID, MODEL_N200, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "turret: no robot\n");
        return 1;
    }
    zr();                                  /* wheels and turret forward */
    ws(1, 1, 1, 20);
    conf_tm(5);
    conf_sn(15, order);
    ac(100, 500, 500);
    sp(SPEED, STEER_RATE, STEER_RATE);
    dp(0, 0);
    da(0, 0);

    printf("     x      y   wheels  turret   off   sonar  should be\n");
    for (corner = 0; corner < 4; corner++) {
        aim(course[corner].x, course[corner].y);
        usleep(300000);                    /* the sonars fire in the new direction */
        while (hypot(course[corner].x - x(), course[corner].y - y()) > NEAR
               && turns++ < MAX_TURNS && State[STATE_BUMPER] == 0) {
            aside = bearing(State[STATE_CONF_STEER], course[corner].x, course[corner].y);
            trans = fabs(aside) < 20.0 ? SPEED : 0;
            vm(trans, rate(aside),
               rate(bearing(State[STATE_CONF_TURRET], PILLAR_X, PILLAR_Y)));
            off = bearing(State[STATE_CONF_TURRET], PILLAR_X, PILLAR_Y);
            expected = hypot(PILLAR_X - x(), PILLAR_Y - y()) - PILLAR_R - SHELL;
            if (turns % 25 == 0)
                printf("%6.1f %6.1f   %6.1f  %6.1f  %4.1f   %5ld  %9.1f\n", x(), y(),
                       State[STATE_CONF_STEER] / 10.0, State[STATE_CONF_TURRET] / 10.0, off,
                       State[STATE_SONAR_0], expected);
            sum += fabs(State[STATE_SONAR_0] - expected);
            worst = fmax(worst, fabs(off));
            looks++;
            usleep(80000);
        }
        st();
        ws(1, 1, 1, 5);
        gs();
        printf("corner %d at (%.1f, %.1f)\n", corner + 1, x(), y());
    }
    printf("the sonar was %.1f in off in the mean, the turret at most %.1f degrees\n",
           sum / looks, worst);
    disconnect_robot(ROBOT_ID);
    return 0;
}
