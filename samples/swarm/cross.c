/*
 * cross.c - one of several robots that go to and fro between a nest and food, over a bridge with two
 * branches.
 *
 * A robot knows both branches, and its place by GPS and compass. It lays a trail on them. Where they
 * part it smells, at the beginnings of both, how many have passed, and chooses one at random, by
 *
 *     P(left) = (K + left)^STEEP / ((K + left)^STEEP + (K + right)^STEEP)
 *
 * as ants do: J.-L. Deneubourg et al., The self-organizing exploratory pattern of the Argentine ant,
 * Journal of Insect Behavior 3 (1990); S. Goss et al., Self-organized shortcuts in the Argentine
 * ant, Naturwissenschaften 76 (1989). It prints a line for each choice: when, and which.
 *
 * Usage:  crs run bridge.xml
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#ifndef DETOUR
#define DETOUR   1              /* of the south; 0: both branches are equally long; 2: of the north, long */
#endif
#ifndef RELEASE
#define RELEASE  3              /* s between two robots that leave first */
#endif

#define K        20.0           /* both of the ants in these papers */
#define STEEP    2.0
#define MARKS    4.0            /* a robot counts as so many ants */
#define CELL     0.7            /* m: of the field */

#define SPEED    130            /* 0.1 inch/s */
#define TURN     100            /* 0.1 inch/s of a wheel, per radian */
#define PERIOD   100000         /* microseconds */
#define LANE     0.13           /* m: robots keep to the right by so much */
#define NEAR     0.2            /* m: a corner is passed */
#define AHEAD    0.1            /* rad: how well a robot looks ahead before it smells */
#define GAP      0.6            /* the share of the sensors' range in which a robot avoids others */
#define AWAY     1.0            /* weights of a near one against that of the aim */
#define ASIDE    0.6
#define INCH     0.00254        /* m: a tenth of one */
#define READINGS 5              /* of the place, from which random numbers are drawn */
#define PI       3.14159265358979

/* A corner of the way on its centre line, and where those who go east pass it, in lanes. */
struct corner {
    double x, y;                /* m */
    int right, up;
};

static const struct corner north_corners[] = {
    { 1.4, 3.15, 0, -1 },
#if DETOUR == 2
    { 2.4, 3.15, 1, -1 }, { 2.4, 8.35, 1, -1 }, { 3.2, 8.35, -1, -1 }, { 3.2, 3.15, -1, -1 },
#endif
    { 4.2, 3.15, 0, -1 },
};
static const struct corner south_corners[] = {
    { 1.4, 2.45, 0, -1 },
#if DETOUR == 1
    { 2.4, 2.45, -1, -1 }, { 2.4, 0.5, -1, -1 }, { 3.2, 0.5, 1, -1 }, { 3.2, 2.45, 1, -1 },
#endif
    { 4.2, 2.45, 0, -1 },
};
static const struct branch {
    const char *name;
    const struct corner *corners;   /* from the west */
    int count;
} north = { "north", north_corners, sizeof north_corners / sizeof *north_corners },
  south = { "south", south_corners, sizeof south_corners / sizeof *south_corners };
static const struct corner nest = { 0.5, 2.8, 0, 0 }, food = { 5.1, 2.8, 0, 0 };
static const struct corner west_fork = { 1.1, 2.8, 0, -1 }, east_fork = { 4.5, 2.8, 0, -1 };

static int trail;                           /* the field */
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

/* Drives for one period towards an aim, a direction from the front, and around who is near. */
static void drive(double aim)
{
    double forward = cos(aim), left = sin(aim), room = 1.0, turn, ahead;
    int i;

    for (i = 0; i < 16; i++) {
        double angle = i * PI / 8, near = fmax(0.0, 1.0 - State[STATE_IR_0 + i] / (15.0 * GAP));

        forward -= near * (AWAY * cos(angle) - ASIDE * sin(angle));
        left -= near * (AWAY * sin(angle) + ASIDE * cos(angle));
        if (cos(angle) > 0.7)
            room = fmin(room, 1.3 * (1.0 - near) - 0.3);
    }
    turn = atan2(left, forward);
    ahead = SPEED * fmax(0.0, fmin(cos(turn), room));
    vm((int)(ahead + TURN * turn), (int)(ahead - TURN * turn), 0);
    usleep(PERIOD);
    look();
}

/* Drives to a corner, eastward or westward (-1). */
static void go_to(const struct corner *to, int east)
{
    double x = to->x + LANE * east * to->right, y = to->y + LANE * east * to->up;

    while (hypot(x - place_x, y - place_y) > NEAR)
        drive(atan2(y - place_y, x - place_x) - heading);
}

/* Returns whether the robot takes the branch to its left. */
static int chooses_left(void)
{
    double left = pow(K + crs_smell(trail, 1), STEEP), right = pow(K + crs_smell(trail, 0), STEEP);

    return rand() < left / (left + right) * RAND_MAX;
}

/* Crosses the bridge, eastward or westward (-1). */
static void cross(int east)
{
    const struct corner *here = east > 0 ? &west_fork : &east_fork;
    const struct corner *there = east > 0 ? &east_fork : &west_fork;
    const struct branch *branch;
    struct timespec now;
    double off;
    int i;

    go_to(here, east);
    while (fabs(off = turned((east > 0 ? 0 : PI) - heading)) > AHEAD)
        drive(off);
    branch = chooses_left() == (east > 0) ? &north : &south;
    clock_gettime(CLOCK_MONOTONIC, &now);
    printf("%ld %s\n", (long)now.tv_sec, branch->name);
    crs_lay_trail(trail, MARKS / CELL);
    for (i = 0; i < branch->count; i++)
        go_to(&branch->corners[east > 0 ? i : branch->count - 1 - i], east);
    go_to(there, east);
    crs_lay_trail(trail, 0);
}

int main(void)
{
    unsigned seed = 0;
    int i;

    trail = crs_find_field("trail");
    if (!connect_robot(1) || trail < 0)
        return 1;
    conf_tm(0);
    for (i = 0; i < READINGS; i++) {
        look();
        seed = 31 * seed + (unsigned)(1e6 * place_x + 1e3 * place_y);
        usleep(PERIOD);
    }
    srand(seed);
    sleep(RELEASE * crs_my_number());
    go_to(&nest, 1);
    for (;;) {
        cross(1);
        go_to(&food, 1);
        cross(-1);
        go_to(&nest, -1);
    }
}
