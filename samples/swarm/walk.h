/*
 * walk.h - how ants walk: they know their place by GPS and compass, and what is near by infrared
 * sensors. Before it is included, SPEED is defined, in 0.1 inch/s, and
 * NEAR, the share of the sensors' range of 15 inches in which a robot avoids what is there.
 */

#ifndef WALK_H
#define WALK_H

#include <math.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define PERIOD   100000         /* microseconds */
#define TURN     100            /* 0.1 inch/s of a wheel, per radian */
#define ACCURATE 0.1            /* rad: how well a robot faces a direction */
#define AWAY     1.0            /* weights of a near one against that of the aim */
#define ASIDE    0.6
#define INCH     0.00254        /* m: a tenth of one */
#define PI       3.14159265358979

static double place_x, place_y, heading;    /* m, m, rad */

/* Measures where the robot is, and what is near. */
static void look(void)
{
    int x, y;

    crs_gps(&x, &y);
    get_cp();
    get_ir();
    place_x = x * INCH;
    place_y = y * INCH;
    heading = State[STATE_COMPASS] * PI / 1800;
}

/* Returns an angle between -PI and PI. */
static double turned(double angle)
{
    return atan2(sin(angle), cos(angle));
}

/* Drives for one period, and looks. */
static void drive(double ahead, double turn)
{
    vm((int)(ahead + TURN * turn), (int)(ahead - TURN * turn), 0);
    usleep(PERIOD);
    look();
}

/* Drives to a place, until it is this near, and to the right of who is in the way. */
static void go_to(double x, double y, double near_enough)
{
    while (hypot(x - place_x, y - place_y) > near_enough) {
        double aim = atan2(y - place_y, x - place_x) - heading, room = 1, turn;
        double forward = cos(aim), left = sin(aim);
        int i;

        for (i = 0; i < 16; i++) {
            double angle = i * PI / 8, near = fmax(0, 1 - State[STATE_IR_0 + i] / (15 * NEAR));

            forward -= near * (AWAY * cos(angle) - ASIDE * sin(angle));
            left -= near * (AWAY * sin(angle) + ASIDE * cos(angle));
            if (cos(angle) > 0.7)
                room = fmin(room, 1.3 * (1 - near) - 0.3);
        }
        turn = atan2(left, forward);
        drive(SPEED * fmax(0, fmin(cos(turn), room)), turn);
    }
}

/* Turns on the spot until the robot faces a direction. */
static void face(double direction)
{
    double off;

    while (fabs(off = turned(direction - heading)) > ACCURATE)
        drive(0, off);
    drive(0, 0);
}
#endif
