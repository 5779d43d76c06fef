/*
 * chain.c - one of any number of robots that form a path from a nest to a source, of which none knows
 * where it is: some of them stand and are its beacons, and the others walk along it.
 *
 * Robot 0 stands in the nest and is beacon 0. A robot that walks roams where it hears the beacon with
 * the highest number, and turns back where it would lose it; there it stops at random, and is a
 * beacon with the next number. A beacon that is the last one leaves at random, so chains that lead
 * nowhere dissolve from their ends. Who comes to the source beside a chain is its last beacon, and
 * this chain stays: the beacons tell each other, as far as the nest. Then the others carry items along
 * it. After
 *
 *     S. Goss and J.-L. Deneubourg, Harvesting by a group of robots, European Conference on
 *     Artificial Life 1 (1992);
 *     S. Nouyan, A. Campo and M. Dorigo, Path formation in a robot swarm, Swarm Intelligence 2 (2008).
 *
 * Beacons call by radio, which reaches 60 cm. Robots know where they are themselves by GPS and compass,
 * and a beacon says where it stands: that takes the place of devices that measure distance and
 * direction of who calls.
 *
 * Usage:  crs run path.xml
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#ifndef LEAVE
#define LEAVE    0.1            /* 1/s: the rate at which the last beacon of a chain leaves */
#endif

#define JOIN     1.0            /* 1/s: the rate at which one stops at the end of what is heard */
#define LIMIT    0.5            /* m: where that end is */
#define BESIDE   0.25           /* m: at a beacon */
#define SPREAD   0.8            /* rad: how far from straight on a robot roams, at most */
#define WANDER   0.2            /* rad: how far a robot that roams turns in a period, at most */
#define SILENT   3.5            /* s: who calls no more has left */
#define CALL     1.0            /* s from one call to the next */
#define MOST     64             /* robots */

#define SPEED    100            /* 0.1 inch/s */
#define TURN     40             /* 0.1 inch/s of a wheel, per radian */
#define PERIOD   0.3            /* s */
#define GAP      0.7            /* the share of the sensors' range in which a robot avoids others */
#define AWAY     1.0            /* weights of a near one against that of the aim */
#define ASIDE    0.6
#define INCH     0.00254        /* m: a tenth of one */
#define PI       3.14159265358979

struct place {
    double x, y;                /* m */
};

/* What a beacon says. */
struct call {
    int number;                 /* from the nest */
    int before;                 /* the robot that is the beacon before it */
    int found;                  /* its chain leads to the source */
    struct place at, from;      /* where it stands, and where the one before does */
};

static struct call heard[MOST];
static double heard_at[MOST];   /* s: when each robot called last */
static double now;              /* s */
static struct place here;
static double heading, way;     /* rad; way is where it roams */

/* Returns a random number between -most and most. */
static double random_to(double most)
{
    return most * (2.0 * rand() / RAND_MAX - 1.0);
}

/* Returns TRUE as often as a rate says. */
static int chance(double rate, double seconds)
{
    return rand() < rate * seconds * RAND_MAX;
}

static double distance(struct place to)
{
    return hypot(to.x - here.x, to.y - here.y);
}

static double direction(struct place from, struct place to)
{
    return atan2(to.y - from.y, to.x - from.x);
}

/* Finds out where the robot is. */
static void look(void)
{
    int x, y;

    crs_gps(&x, &y);
    here.x = x * INCH;
    here.y = y * INCH;
    gs();
    heading = State[STATE_COMPASS] * PI / 1800;
}

/* Lets time pass, and hears who has called. */
static void hear(double seconds)
{
    struct crs_message message;
    struct timespec time;

    usleep((int)(seconds * 1e6));
    clock_gettime(CLOCK_MONOTONIC, &time);
    now = time.tv_sec + 1e-9 * time.tv_nsec;
    while (crs_receive(&message, 0)) {
        memcpy(&heard[message.from], message.data, sizeof *heard);
        heard_at[message.from] = now;
    }
}

static int is_heard(int robot)
{
    return heard_at[robot] > 0 && heard_at[robot] > now - SILENT;
}

/* Returns whether a beacon counts more than another one: if it is of the path to the source, else if
   its number is higher, or lower. */
static int is_better(const struct call *one, const struct call *other, int lower)
{
    if (one->found != other->found)
        return one->found;
    return lower ? one->number < other->number : one->number > other->number;
}

/* Returns the beacon to go to, -1 if none is heard. */
static int beacon(int lower)
{
    int best = -1, i;

    for (i = 0; i < MOST; i++)
        if (is_heard(i) && (best < 0 || is_better(&heard[i], &heard[best], lower)))
            best = i;
    return best;
}

/* Drives in a direction for a period, and around who is near; returns whether there is room ahead. */
static int drive(double to)
{
    double forward = cos(to - heading), left = sin(to - heading), room = 1, turn, ahead;
    int i;

    for (i = 0; i < 16; i++) {
        double angle = i * PI / 8, near = fmax(0, 1 - State[STATE_IR_0 + i] / (15 * GAP));

        forward -= near * (AWAY * cos(angle) - ASIDE * sin(angle));
        left -= near * (AWAY * sin(angle) + ASIDE * cos(angle));
        if (cos(angle) > 0.7)
            room = fmin(room, 1.3 * (1 - near) - 0.3);
    }
    turn = atan2(left, forward);
    ahead = SPEED * fmax(0, fmin(cos(turn), room));
    vm((int)(ahead + TURN * turn), (int)(ahead - TURN * turn), 0);
    hear(PERIOD);
    look();
    return room > 0.3;
}

/* Returns whether a chain goes on after this robot: 2 if as far as to the source. */
static int goes_on(void)
{
    int me = crs_my_number(), found = 0, i;

    for (i = 0; i < MOST; i++)
        if (is_heard(i) && heard[i].before == me)
            found = heard[i].found || found == 2 ? 2 : 1;
    return found;
}

/* Follows the beacon with the lowest number, if that makes the chain shorter. */
static void follow(struct call *own)
{
    int i;

    for (i = 0; i < MOST; i++)
        if (is_heard(i) && heard[i].number < heard[own->before].number)
            own->before = i;
    own->number = heard[own->before].number + 1;
    own->from = heard[own->before].at;
}

/* Is a beacon, as long as the one before calls; as the last one of a chain that does not lead to the
   source it leaves at random. */
static void stand(struct call own)
{
    vm(0, 0, 0);
    while (own.number == 0 || is_heard(own.before)) {
        int next = goes_on();

        if (own.number > 0)
            follow(&own);
        if (next == 2 && !own.found) {
            own.found = 1;
            if (own.number == 0)
                printf("%.1f path\n", now);
        }
        if (!next && own.number > 0 && !own.found && chance(LEAVE, CALL))
            return;
        crs_broadcast(0, &own, sizeof own);
        hear(CALL);
    }
}

/* Returns whether no beacon that is heard is near. */
static int is_outside(void)
{
    int i;

    for (i = 0; i < MOST; i++)
        if (is_heard(i) && distance(heard[i].at) < LIMIT)
            return 0;
    return 1;
}

/* Stands as the beacon after that of a robot. */
static void stand_after(int before, int found)
{
    struct call own = { heard[before].number + 1, before, found, here, heard[before].at };

    stand(own);
}

/* Roams about a beacon for a period: ahead of it, if it has just come there. */
static void roam(int to, int has_come)
{
    const struct call *call = &heard[to];

    if (has_come)
        way = call->number ? direction(call->from, call->at) + random_to(SPREAD) : random_to(PI);
    if (distance(call->at) > LIMIT) {
        if (!call->found && is_outside() && chance(JOIN, PERIOD)) {
            stand_after(to, 0);
            return;
        }
        way = direction(here, call->at) + random_to(SPREAD);
    }
    way += random_to(WANDER);
    if (!drive(way))
        way += random_to(PI);
}

/* Walks for ever: out to the source, and back to the nest with an item. */
static void walk(void)
{
    int loaded = 0, last = 0, to;

    for (;; last = to < 0 ? last : to) {
        to = beacon(loaded);
        if (to < 0) {
            if (distance(heard[last].at) < BESIDE)
                last = 0;                           /* who was here has left */
            drive(direction(here, heard[last].at));
        } else if (!loaded && crs_take()) {
            loaded = 1;
            if (!heard[to].found)
                stand_after(to, 1);
        } else if (loaded && crs_drop()) {
            loaded = 0;
        } else if (heard[to].found && distance(heard[to].at) > BESIDE) {
            drive(direction(here, heard[to].at));
        } else {
            roam(to, to != last);
        }
    }
}

int main(void)
{
    struct call nest = { 0, -1, 0 };

    if (!connect_robot(1))
        return 1;
    conf_tm(0);
    look();
    srand((unsigned)(1e6 * here.x + 1e3 * here.y));     /* noisy: another one for each seed */
    nest.at = here;
    if (crs_my_number() == 0)
        stand(nest);
    walk();
}
