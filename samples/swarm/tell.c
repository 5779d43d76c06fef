/*
 * tell.c - one of any number of robots that look for a source of items, carry them to a nest, and tell
 * each other where the source is.
 *
 * A robot knows the way to the nest, by GPS and compass, but not where the source is. It roams until
 * it gets an item or hears of the source by radio; from then on it goes to and fro. With an item it
 * tells once a second where it got that. There is no answer: who did not hear it this time hears it
 * next time.
 *
 * What its infrared sensors detect, be it a robot or a wall, slows it down and pushes it away and to
 * the right, so that robots that meet pass each other as ships do.
 *
 * Usage:  crs run radio.xml
 */

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define CALLS    5              /* periods from one call to the next */
#define WANDER   0.3            /* rad: how far a robot that roams turns in a period, at most */
#define SPEED    100            /* 0.1 inch/s */
#define TURN     50             /* 0.1 inch/s of a wheel, per radian */
#define PERIOD   200000         /* microseconds */
#define AWAY     1.0            /* weights of a near obstacle against that of the aim */
#define ASIDE    0.6
#define PI       3.14159265358979

struct place {
    int x, y;                   /* 0.1 inch */
};

static const struct place nest = { 276, 591 };      /* 70 cm, 1.5 m */

static struct place here, source;
static int knows;               /* where the source is */

/* Hears where the source is. */
static void hear(void)
{
    struct crs_message message;

    while (crs_receive(&message, 0))
        if (!knows) {
            memcpy(&source, message.data, sizeof source);
            knows = 1;
        }
}

/* Returns the direction of a place, from the front. */
static double direction(const struct place *to)
{
    return atan2(to->y - here.y, to->x - here.x) - State[STATE_COMPASS] * PI / 1800;
}

/* Returns the next direction of a robot that looks for the source. */
static double anywhere(void)
{
    static double turn;

    turn += WANDER * (2.0 * rand() / RAND_MAX - 1.0);
    return turn = fmax(-WANDER, fmin(turn, WANDER));
}

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
    int loaded = 0, period;

    if (!connect_robot(1) || !crs_gps(&here.x, &here.y))
        return 1;
    conf_tm(0);
    srand(1000 * here.x + here.y);      /* a noisy position: another one for each seed */
    for (period = 0;; period++, usleep(PERIOD)) {
        crs_gps(&here.x, &here.y);
        gs();
        hear();
        if (!loaded && crs_take()) {
            loaded = knows = 1;
            source = here;
        } else if (loaded && crs_drop()) {
            loaded = 0;
        }
        if (loaded && period % CALLS == 0)
            crs_broadcast(0, &source, sizeof source);
        drive(loaded ? direction(&nest) : knows ? direction(&source) : anywhere());
    }
}
