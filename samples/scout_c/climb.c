/*
 * climb.c - climbs a ramp by inclinometer, with limp wheels half-way up.
 *
 * On a slope a robot is pulled downhill: with limp wheels it rolls back, with its motors
 * on it holds its position. On the ramp, this robot makes its wheels limp for a moment,
 * brakes, and climbs on until the ground is level again.
 *
 * The height follows from encoders and inclinometer: a distance s along a slope of pitch
 * p raises the robot by s sin p.
 *
 * Usage:  crs run climb.c slope.xml
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define ROBOT_ID  1
#define SPEED     120            /* 0.1 inch/s */
#define PERIOD    50000          /* microseconds */
#define STEEP     50             /* 0.1 degree: on a ramp */
#define LEVEL     15             /* on level ground */
#define HALF_WAY  700            /* 0.1 inch along the ramp */
#define MAX_TURNS 1200

static double height;            /* inches */
static long last;                /* previous encoder position, 0.1 inch */

/* Reads encoders and tilt, and updates the height; returns the pitch. */
static int look(void)
{
    int pitch = 0, roll = 0;
    long here;

    get_rc();
    here = State[STATE_CONF_X];
    if (!crs_tilt(&pitch, &roll))
        printf("no inclinometer\n");
    height += (here - last) / 10.0 * sin(pitch * M_PI / 1800.0);
    last = here;
    return pitch;
}

/* Drives until the pitch is at least, or at most, so much, or the way is made. */
static int drive(int least, int most, long way)
{
    int turn, pitch = 0;
    long start = last;

    vm(SPEED, SPEED, 0);
    for (turn = 0; turn < MAX_TURNS; turn++) {
        usleep(PERIOD);
        pitch = look();
        if (pitch >= least || pitch <= most || last - start >= way)
            break;
    }
    return pitch;
}

static void hold_and_let_go(void)
{
    long before, rolled;

    st();
    ws(1, 1, 0, 5);
    look();
    before = last;
    lp();
    usleep(1000000);
    look();
    st();
    rolled = last - before;
    ws(1, 1, 0, 5);
    look();
    before = last;
    usleep(1000000);
    look();
    printf("let go for a second it rolls %.1f in, held it moves %.1f in\n",
           rolled / 10.0, (last - before) / 10.0);
}

int main(void)
{
    int pitch;

    if (!connect_robot(ROBOT_ID))
        return 1;
    ac(300, 300, 0);
    last = State[STATE_CONF_X];
    pitch = drive(STEEP, -9999, 99999);
    printf("a ramp of %.0f degrees begins after %.0f in\n", pitch / 10.0, last / 10.0);
    drive(9999, -9999, HALF_WAY);
    hold_and_let_go();
    drive(9999, LEVEL, 99999);
    drive(9999, -9999, 100);
    st();
    ws(1, 1, 0, 5);
    printf("level again after %.0f in, %.0f in above the floor\n", last / 10.0, height);
    disconnect_robot(ROBOT_ID);
    return 0;
}
