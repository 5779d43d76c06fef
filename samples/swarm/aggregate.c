/*
 * aggregate.c - one of any number of robots that gather, though none knows where others are.
 *
 * A robot roams, and stops at random where it hears others. The more it hears, the longer it stays:
 * it leaves at a rate of
 *
 *     LEAVE / near^STEEP
 *
 * so groups grow the faster, the larger they are, as those of cockroaches do: R. Jeanson et al.,
 * Self-organized aggregation in cockroaches, Animal Behaviour 69 (2005). Robots hear each other by
 * radio, as far as 25 cm.
 *
 * Usage:  crs run aggregation.xml
 */

#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#ifndef STEEP
#define STEEP    2
#endif

#define SPEED    80             /* 0.1 inch/s */
#define TURN     60             /* 0.1 inch/s of a wheel, per radian */
#define PERIOD   0.1            /* s */
#define CALLS    5              /* periods from one call to the others to the next */
#define STOP     1.0            /* 1/s: the rate to stop beside others */
#define LEAVE    0.1            /* 1/s: the rate to leave a single one */
#define GAP      0.3            /* the share of the sensors' range that robots keep */
#define PI       3.14159265358979

/* Returns TRUE with a probability. */
static int chance(double probability)
{
    return rand() < probability * RAND_MAX;
}

/* Calls the others; returns how many have called since the last time. */
static int call(void)
{
    struct crs_message message;
    int count = 0;

    while (crs_receive(&message, 0))
        count++;
    crs_broadcast(0, "", 1);
    return count;
}

/* Returns whether the robot is to stand, by how many are near. */
static int stands(int stood, int near)
{
    double time = PERIOD * CALLS;

    if (stood)
        return !chance(time * LEAVE / pow(near > 1 ? near : 1, STEEP));
    return near > 0 && chance(time * STOP);
}

/* Drives ahead, and away from what is near. */
static void roam(void)
{
    double forward = 1.0, left = 0.2 * rand() / RAND_MAX - 0.1, room = 1.0, turn, ahead;
    int i;

    get_ir();
    for (i = 0; i < 16; i++) {
        double angle = i * PI / 8, reading = State[STATE_IR_0 + i] / 15.0;

        if (reading < GAP) {
            forward -= cos(angle);
            left -= sin(angle);
            if (cos(angle) > 0.3)
                room = 0.0;
        }
    }
    turn = atan2(left, forward);
    ahead = SPEED * fmin(fmax(0.0, cos(turn)), room);
    vm((int)(ahead + TURN * turn), (int)(ahead - TURN * turn), 0);
}

int main(void)
{
    int standing = 0, turn, x, y;

    if (!connect_robot(1))
        return 1;
    conf_tm(0);
    crs_gps(&x, &y);
    srand(1000 * x + y);                /* a noisy position: another one for each seed */
    for (turn = 0;; turn++, usleep((int)(PERIOD * 1e6))) {
        if (turn % CALLS == 0)
            standing = stands(standing, call());
        if (standing)
            vm(0, 0, 0);
        else
            roam();
    }
}
