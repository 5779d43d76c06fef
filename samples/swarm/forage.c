/*
 * forage.c - one of any number of robots that carry items from a source to a nest.
 *
 * A robot drives to a place at random first, then to the source, takes an item there, which needs
 * nothing but to be there, and brings it to the nest: it prints a line for each. It knows both
 * places, and its own by GPS and compass. What its infrared sensors detect, be it a robot or a
 * wall, slows it down and pushes it away and to the right, so that robots that meet pass each
 * other as ships do.
 *
 * Usage:  crs run foraging.xml
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define SPEED    100            /* 0.1 inch/s */
#define TURN     60             /* 0.1 inch/s of a wheel, per radian */
#define PERIOD   100000         /* microseconds */
#define PLACE    157            /* 0.1 inch: the radius of source and nest, 40 cm */
#define AWAY     1.0            /* weights of a near obstacle against that of the aim */
#define ASIDE    0.6
#define PI       3.14159265358979

static const struct place {
    int x, y;                   /* 0.1 inch */
} source = { 1969, 787 }, nest = { 394, 787 };

/* Drives towards an aim, a direction from the front, and around what is near. */
static void drive(double aim)
{
    double forward = cos(aim), left = sin(aim), room = 1.0, turn, ahead;
    int i;

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
    struct place start;
    const struct place *to = &start;
    int x, y;

    if (!connect_robot(1) || !crs_gps(&x, &y))
        return 1;
    conf_tm(0);
    srand(1000 * x + y);                /* a noisy position: another one for each seed */
    start.x = rand() % (source.x + nest.x);
    start.y = rand() % (2 * source.y);
    for (;; usleep(PERIOD)) {
        crs_gps(&x, &y);
        if (hypot(to->x - x, to->y - y) < PLACE) {
            if (to == &nest)
                puts("an item");
            to = to == &source ? &nest : &source;
        }
        get_ir();
        get_cp();
        drive(atan2(to->y - y, to->x - x) - State[STATE_COMPASS] * PI / 1800);
    }
}
