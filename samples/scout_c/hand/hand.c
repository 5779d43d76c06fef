/*
 * hand.c - arrange cans in a row with a two-joint arm.
 *
 * The joint angles for a position of the tip are given by the arm's inverse kinematics:
 * the elbow by the law of cosines, then the shoulder.
 *
 *      d^2 = x^2 + y^2
 *      cos elbow = (d^2 - upper^2 - fore^2) / (2 upper fore)
 *      shoulder  = atan2(y, x) - atan2(fore sin elbow, upper + fore cos elbow)
 *
 * Usage:  crs run hand/hand.xml              the world names the program
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "crs.h"

#define UPPER   14.0         /* inch, as in arm.xml */
#define FORE    12.0
#define DEGREES (180.0 / M_PI)

struct place {
    double x, y;             /* inch, forward of the robot and to the left */
};

static const struct { const char *name; struct place from, to; } job[] = {
    { "red",   { 20, -8 }, {  0, 22 } },
    { "green", { 24,  0 }, {  4, 22 } },
    { "blue",  { 18, 12 }, { -4, 22 } },
};

/* Computes the joint angles for a point, 0.1 degree; FALSE if it is out of reach. */
static int solve(struct place p, int *shoulder, int *elbow)
{
    double cosine = (p.x * p.x + p.y * p.y - UPPER * UPPER - FORE * FORE) / (2 * UPPER * FORE);
    double bend;

    if (fabs(cosine) > 1.0)
        return 0;
    bend = acos(cosine);
    *elbow = (int)lround(10 * DEGREES * bend);
    *shoulder = (int)lround(10 * DEGREES
                            * (atan2(p.y, p.x) - atan2(FORE * sin(bend), UPPER + FORE * cosine)));
    return 1;
}

/* Moves the tip to a point and waits until it arrives. */
static int reach(struct place p)
{
    int shoulder, elbow, s, e;

    if (!solve(p, &shoulder, &elbow) || !crs_arm_move(shoulder, elbow))
        return 0;
    do {
        usleep(50000);
        crs_arm_get(&s, &e, NULL, NULL);
    } while (s != shoulder || e != elbow);
    return 1;
}

/* Operates the hand; returns the weight that it then holds, gram. */
static int hand(int what)
{
    int weight;

    crs_hand(what);
    usleep(200000);
    crs_get_hand(&weight);
    return weight;
}

int main(void)
{
    unsigned n;
    int s, e, x, y, weight;

    for (n = 0; n < sizeof job / sizeof job[0]; n++) {
        if (!reach(job[n].from) || (weight = hand(CRS_CLOSE)) == 0) {
            printf("%s: not there\n", job[n].name);
            return 1;
        }
        if (!reach(job[n].to) || hand(CRS_OPEN) != 0) {
            printf("%s: no room\n", job[n].name);
            return 1;
        }
        crs_arm_get(&s, &e, &x, &y);
        printf("%-5s %d g: shoulder %6.1f, elbow %6.1f put the tip at %5.1f, %5.1f in\n",
               job[n].name, weight, s / 10.0, e / 10.0, x / 10.0, y / 10.0);
    }
    crs_arm_move(0, 0);
    return 0;
}
