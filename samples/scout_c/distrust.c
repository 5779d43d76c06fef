/* Drives back and forth between two walls, and detects a faulty sonar.

   While the robot drives straight, obstacles ahead approach by exactly the distance driven. A
   sonar that repeatedly contradicts this is ignored until its readings are consistent again, and
   its neighbours replace it; a single missed echo is tolerated. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/time.h>
#include <unistd.h>
#include "Nclient.h"

#define SPEED 150          /* 0.1 in/s */
#define STOP 30.0          /* distance from a wall at which it turns, inches */
#define NOTHING 255        /* reading without an echo */
#define FITS 4.0           /* inches; readings are up to 0.12 s old */
#define ENOUGH 4           /* strikes until it is ignored */
#define LEGS 4
#define HALF_TURN 213      /* 0.1 in that a wheel runs for it: pi / 2 times the wheel base */

struct sonar {
    int number;
    double slant;          /* forward component of its distance */
    double expected;       /* expected reading, 0 for any */
    int strikes;
    int believed;
};

static struct sonar sonars[] = {
    { 0, 1.0, 0, 0, 1 }, { 1, 0.976, 0, 0, 1 }, { 15, 0.976, 0, 0, 1 },   /* cos 12.5 deg */
};

#define EACH(s) for (s = sonars; s < sonars + sizeof sonars / sizeof sonars[0]; s++)

static double now(void)
{
    static struct timeval start;
    struct timeval t;

    gettimeofday(&t, NULL);
    if (start.tv_sec == 0)
        start = t;
    return t.tv_sec - start.tv_sec + (t.tv_usec - start.tv_usec) / 1e6;
}

static double way_since(void)
{
    static long x, y;
    double way;

    way = hypot(State[STATE_CONF_X] - x, State[STATE_CONF_Y] - y) / 10;
    x = State[STATE_CONF_X];
    y = State[STATE_CONF_Y];
    return way;
}

/* Compares a reading with the previous one and the distance driven since. */
static void judge(struct sonar *s, double way)
{
    double says = State[STATE_SONAR_0 + s->number];
    double should = s->expected - way / s->slant;

    if (s->expected == 0 || s->expected == NOTHING) {      /* the first echo may have any value */
        s->expected = says;
        return;
    }
    if (fabs(says - should) < FITS)
        s->strikes -= s->strikes > 0;
    else
        s->strikes += s->strikes < ENOUGH;
    s->expected = says == NOTHING ? should : says;
    if (s->expected <= 0)
        s->expected = NOTHING;

    if (s->believed && s->strikes == ENOUGH) {
        s->believed = 0;
        printf("%5.1f s  sonar %d says %g in, %.0f would fit: not believed any more\n",
               now(), s->number, says, should);
    } else if (!s->believed && s->strikes == 0) {
        s->believed = 1;
        printf("%5.1f s  sonar %d fits again\n", now(), s->number);
    }
}

/* Returns the free distance ahead, by the first trusted sonar; -1 if there is none. */
static double ahead(void)
{
    struct sonar *s;

    EACH(s)
        if (s->believed)
            return State[STATE_SONAR_0 + s->number] * s->slant;
    return -1;
}

static void turn_around(void)
{
    struct sonar *s;

    st();
    ws(1, 1, 0, 10);
    pr(HALF_TURN, -HALF_TURN, 0);
    ws(1, 1, 0, 20);
    EACH(s)
        s->expected = 0;
    gs();
    way_since();
}

int main(void)
{
    int order[] = { 0, 1, 15, 255 };
    int leg;

    if (!connect_robot(1))
        return EXIT_FAILURE;
    now();
    conf_sn(10, order);
    sp(SPEED, SPEED, 0);
    ac(150, 150, 0);

    for (leg = 1; leg <= LEGS; leg++) {
        vm(SPEED, SPEED, 0);
        while (ahead() > STOP) {
            struct sonar *s;
            double way;

            usleep(500000);
            gs();
            way = way_since();
            EACH(s)
                judge(s, way);
        }
        if (ahead() < 0) {
            st();
            printf("%5.1f s  no sonar is believed: stops\n", now());
            return EXIT_FAILURE;
        }
        printf("%5.1f s  leg %d ends %.0f in before a wall\n", now(), leg, ahead());
        turn_around();
    }
    disconnect_robot(1);
    return EXIT_SUCCESS;
}
