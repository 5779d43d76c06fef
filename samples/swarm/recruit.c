/*
 * recruit.c - one of any number of robots that look for a source of items, and carry them to a nest.
 *
 * A robot knows the way to the nest, by GPS and compass, but not where the source is. It roams until
 * it gets an item, and drives straight home with it. On this way it lays a trail. Who roams, and
 * smells a trail, follows it away from the nest: it heads for where it smells more.
 *
 * What its infrared sensors detect, be it a robot or a wall, slows it down and pushes it away and to
 * the right, so that robots that meet pass each other as ships do.
 *
 * Usage:  crs run trails.xml
 */

#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#ifndef TRAILS
#define TRAILS   1              /* 0: nobody lays a trail */
#endif

#define TRAIL    100.0          /* per metre */
#define FAINT    0.5            /* less than this is no trail */
#define STEER    0.8            /* rad, if only one antenna smells a trail */
#define WANDER   0.3            /* rad: how far a robot that roams turns in a period, at most */
#define SPEED    100            /* 0.1 inch/s */
#define TURN     50             /* 0.1 inch/s of a wheel, per radian */
#define PERIOD   200000         /* microseconds */
#define AWAY     1.0            /* weights of a near obstacle against that of the aim */
#define ASIDE    0.6
#define INCH     0.00254        /* m: a tenth of one */
#define PI       3.14159265358979

static const double nest_x = 0.7, nest_y = 1.5;     /* m */

static int trail;                                   /* the field */
static double roaming;                              /* rad: the turn of a robot that roams */

/* Returns the direction of the nest, from the front. */
static double homeward(void)
{
    int x, y;

    crs_gps(&x, &y);
    get_cp();
    return atan2(nest_y - y * INCH, nest_x - x * INCH) - State[STATE_COMPASS] * PI / 1800;
}

/* Returns the next direction of a robot that looks for the source. */
static double outward(void)
{
    double right = crs_smell(trail, 0), left = crs_smell(trail, 1);

    if (TRAILS && right + left > FAINT)
        return homeward() + PI + STEER * (left - right) / (left + right);
    roaming += WANDER * (2.0 * rand() / RAND_MAX - 1.0);
    roaming = fmax(-WANDER, fmin(roaming, WANDER));
    return roaming;
}

/* Drives towards an aim, a direction from the front, and around what is near. */
static void drive(double aim)
{
    double forward = cos(aim), left = sin(aim), room = 1.0, turn, ahead;
    int i;

    get_ir();
    for (i = 0; i < 16; i++) {
        double angle = i * PI / 8, near = 1.0 - State[STATE_IR_0 + i] / 15.0;

        forward -= near * (AWAY * cos(angle) - ASIDE * sin(angle));
        left -= near * (AWAY * sin(angle) + ASIDE * cos(angle));
        if (cos(angle) > 0.7)
            room = fmin(room, 1.3 * (1.0 - near) - 0.3);
    }
    turn = atan2(left, forward);
    ahead = SPEED * fmax(0.0, fmin(cos(turn), room));
    vm((int)(ahead + TURN * turn), (int)(ahead - TURN * turn), 0);
}

int main(void)
{
    int loaded = 0, x, y;

    trail = crs_find_field("trail");
    if (!connect_robot(1) || !crs_gps(&x, &y) || trail < 0)
        return 1;
    conf_tm(0);
    srand(1000 * x + y);                /* a noisy position: another one for each seed */
    for (;; usleep(PERIOD)) {
        if (!loaded && crs_take()) {
            loaded = 1;
            crs_lay_trail(trail, TRAILS * TRAIL);
        } else if (loaded && crs_drop()) {
            loaded = 0;
            crs_lay_trail(trail, 0);
        }
        drive(loaded ? homeward() : outward());
    }
}
