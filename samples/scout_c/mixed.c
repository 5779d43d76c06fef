/*
 * mixed.c - one behaviour for several types of robots.
 *
 * The program is passed the type of its robot, and looks up the differences: the
 * directions of the sonars, the width, and the meaning of vm(). The rest is the same for
 * all: drive ahead, steer away from obstacles, and turn in place if the way is blocked.
 * It prints its position regularly.
 *
 * Usage:  crs run mixed.c worlds/mixed.xml      the world names each robot's kind
 *         crs run mixed.c --robot amigobot -- amigobot
 */

#include <math.h>
#include <stdio.h>
#include <string.h>
#include "Nclient.h"

#define DEG     (3.14159265358979 / 180.0)
#define STEPS   1200
#define TELL    400                     /* steps per output line */
#define NEAR    36.0                    /* range of obstacles that count [in] */
#define STOP    11.0                    /* blocked if an obstacle ahead is nearer [in] */
#define FREE    20.0                    /* free distance needed to continue [in] */
#define SPEED   80                      /* [0.1 in/s] */
#define TURN    400                     /* [0.1 deg/s] */

/* Directions of the sonars by number, counter-clockwise from the front. */
static const double nomad_ring[16] = {
    0, 22.5, 45, 67.5, 90, 112.5, 135, 157.5, 180, -157.5, -135, -112.5, -90, -67.5, -45, -22.5
};
static const double pioneer_rings[16] = {
    90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170, 170, 150, 130, 90
};
static const double amigo_sonars[8] = { 90, 41, 15, -15, -41, -90, -145, 145 };

static const struct kind {
    const char *name;
    int sonars;
    const double *direction;
    double axle;                        /* wheel base [in]; 0: steered wheels */
} kinds[] = {
    { "scout", 16, nomad_ring, 13.59 },
    { "nomad200", 16, nomad_ring, 0.0 },
    { "pioneer2dx", 16, pioneer_rings, 14.06 },
    { "amigobot", 8, amigo_sonars, 7.158 },
};

static const struct kind *me;

static const struct kind *find_kind(const char *name)
{
    size_t k;

    for (k = 0; k < sizeof kinds / sizeof kinds[0]; k++)
        if (strcmp(kinds[k].name, name) == 0)
            return &kinds[k];
    return NULL;
}

/* Drives at a speed [0.1 in/s] while turning [0.1 deg/s, to the left]. */
static void drive(double speed, double turn)
{
    double wheel = turn * DEG * me->axle / 2.0;

    if (me->axle > 0.0)
        vm((int)(speed + wheel), (int)(speed - wheel), 0);
    else
        vm((int)speed, (int)turn, (int)turn);   /* the turret, with the sonars, turns along */
}

/* Returns the nearest echo within an angle of the front [in]. */
static double ahead(double degrees)
{
    double nearest = 255.0;
    int s;

    for (s = 0; s < me->sonars; s++)
        if (fabs(me->direction[s]) <= degrees && State[STATE_SONAR_0 + s] < nearest)
            nearest = State[STATE_SONAR_0 + s];
    return nearest;
}

/* Returns the obstacles on the left minus those on the right, weighted by nearness. */
static double crowded_left(void)
{
    double sum = 0.0;
    int s;

    for (s = 0; s < me->sonars; s++) {
        double away = State[STATE_SONAR_0 + s], angle = me->direction[s];
        if (away < NEAR && fabs(angle) <= 100.0)
            sum += sin(angle * DEG) * (NEAR - away) / NEAR;
    }
    return sum;
}

int main(int argc, char **argv)
{
    int step, blocked = 0, side = 0, turns = 0;

    me = find_kind(argc > 1 ? argv[1] : "scout");
    if (me == NULL) {
        fprintf(stderr, "no kind of robot that I know: %s\n", argv[1]);
        return 2;
    }
    if (!connect_robot(1))
        return 1;
    ac(200, me->axle > 0.0 ? 200 : 400, 400);
    for (step = 1; step <= STEPS; step++) {
        double room, left;

        gs();
        room = ahead(50.0);
        left = crowded_left();
        if (!blocked && room < STOP) {
            blocked = 1;
            side = left > 0.0 ? -1 : 1;
            turns++;
        } else if (blocked && room > FREE) {
            blocked = 0;
        }
        if (blocked)
            drive(0.0, side * TURN);
        else
            drive(room < NEAR ? SPEED * room / NEAR : SPEED, -left * TURN / 2.0);
        if (step % TELL == 0)
            printf("%-10s step %4d at %6.1f %6.1f in, %2d turns\n", me->name, step,
                   State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0, turns);
    }
    st();
    return 0;
}
