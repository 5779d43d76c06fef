/*
 * by_compass.c - drives a square by compass, because the wheels are unequal.
 *
 * One wheel is slightly larger than the other. When told to drive straight, the robot
 * drives in a curve, which its encoders do not measure. The compass does: on each side of
 * the square it holds the heading, and the encoders measure only the distance.
 *
 * The position is tracked twice: by encoders alone, and by distance and compass. Both are
 * printed; at the end the second one is correct.
 *
 * Usage:  crs run by_compass.c slippery.xml
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define SIDE       600.0        /* 0.1 inch */
#define SPEED      80           /* of each wheel, 0.1 inch/s */
#define TURN_MAX   60
#define STRAIGHT   20           /* heading error that allows driving, 0.1 degree */
#define LOOP       100000       /* microseconds: as often as the compass measures */
#define MAX_TURNS  1500

static double x, y;             /* from distance and compass, 0.1 inch, x along the first side */
static double heading;          /* from the direction of the first side, degrees */
static double north;            /* compass reading in that direction, degrees */
static long last_x, last_y;     /* previous encoder position */

static double between(double degrees)
{
    return remainder(degrees, 360.0);
}

/* Reads encoders and compass, updates the position, and returns the distance since then. */
static double look(void)
{
    double way, before = heading;

    get_rc();
    get_cp();
    heading = between(State[STATE_COMPASS] / 10.0 - north);
    way = hypot(State[STATE_CONF_X] - last_x, State[STATE_CONF_Y] - last_y);
    last_x = State[STATE_CONF_X];
    last_y = State[STATE_CONF_Y];
    before += between(heading - before) / 2.0;
    x += way * cos(before * M_PI / 180.0);
    y += way * sin(before * M_PI / 180.0);
    return way;
}

/* Drives, correcting the heading; speed 0 to turn in place. */
static void steer(int speed, double wanted)
{
    double aside = 6.0 * between(wanted - heading);
    int turn = (int) (aside > TURN_MAX ? TURN_MAX : aside < -TURN_MAX ? -TURN_MAX : aside);

    vm(speed + turn, speed - turn, 0);
    usleep(LOOP);
}

int main(void)
{
    double way, off, worst;
    int side, turns = 0;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "by_compass: no robot\n");
        return 1;
    }
    conf_tm(5);
    conf_cp(1);
    ac(300, 300, 0);
    dp(0, 0);
    da(0, 0);
    get_cp();
    north = State[STATE_COMPASS] / 10.0;
    look();

    printf("side   worst   by compass: x      y   heading   by encoders: x      y   heading\n");
    for (side = 0; side < 4; side++) {
        do {
            look();
            steer(0, 90.0 * side);
        } while (fabs(between(90.0 * side - heading)) * 10.0 > STRAIGHT && turns++ < MAX_TURNS);
        for (way = worst = 0.0; way < SIDE && turns++ < MAX_TURNS; way += look()) {
            steer(SPEED, 90.0 * side);
            off = fabs(between(90.0 * side - heading));
            worst = off > worst ? off : worst;
        }
        st();
        ws(1, 1, 0, 5);
        look();
        printf("%4d   %5.1f   %13.1f %6.1f   %7.1f   %14.1f %6.1f   %7.1f\n", side + 1, worst,
               x / 10.0, y / 10.0, heading, State[STATE_CONF_X] / 10.0,
               State[STATE_CONF_Y] / 10.0, State[STATE_CONF_STEER] / 10.0);
    }
    printf("the square closes within %.1f in by compass; encoders say %.1f in\n",
           hypot(x, y) / 10.0, hypot(last_x, last_y) / 10.0);
    disconnect_robot(ROBOT_ID);
    return turns >= MAX_TURNS;
}
