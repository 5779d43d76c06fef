/*
 * potential.c - go to a goal among obstacles by a potential field.
 *
 * The goal pulls with a constant force. Every obstacle that a sonar hears pushes
 * away, the harder the nearer it is (Khatib 1986):
 *
 *     F = K (1/d - 1/D) / d^2      for d < D, else nothing
 *
 * The robot turns towards the sum of the forces and drives the slower, the more
 * it has to turn and the nearer something is ahead.
 *
 * The sum may vanish in front of a wall: a local minimum. When the robot has not
 * come nearer to the goal for a while, the push is turned by a right angle for
 * some time, so that it slides along what is in the way.
 *
 * Each sonar fires once in 0.96 s. The echoes are kept as points on the floor, in
 * the frame of the encoders, so that they stay where they were heard while the
 * robot drives on.
 *
 * Usage:  crs run potential.c cluttered.xml               to (200, 120)
 *         crs run potential.c cluttered.xml -- 150 0      inches ahead and to the left
 */

#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define N_SONARS   16
#define SHELL      8.0      /* radius of the robot, inches */
#define RANGE      20.0     /* D: range of the repulsion, inches from the shell */
#define STRENGTH   150.0    /* K: against a pull of 1 */
#define NEAREST    3.0      /* a distance below is taken for this one, inches */
#define ARRIVED    5.0      /* radius of the goal, inches */
#define TOP_SPEED  80.0     /* 0.1 inch/s */
#define TOP_STEER  400.0    /* 0.1 degree/s */
#define STUCK      6.0      /* seconds without coming nearer: a local minimum */
#define SLIDE      8.0      /* duration of sliding, seconds */
#define LOOP       0.1      /* approximate duration of an iteration, seconds */
#define MAX_LOOPS  1500

typedef struct { double x, y; } Vector;

typedef struct {
    Vector at;
    int heard;              /* nothing within RANGE: no point */
    int reading;            /* inches */
} Echo;

static Echo echoes[N_SONARS];
static Vector here;         /* inches */
static double heading;      /* radians */
static int order[N_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };

static double clip(double value, double limit)
{
    return value > limit ? limit : value < -limit ? -limit : value;
}

/* Normalises an angle to -pi to pi. */
static double normal(double angle)
{
    return atan2(sin(angle), cos(angle));
}

static double distance(Vector a, Vector b)
{
    return hypot(a.x - b.x, a.y - b.y);
}

/* Reads the robot, and updates the points of sonars with new readings. */
static void sense(void)
{
    int i, reading;
    double direction;

    gs();
    here.x = State[STATE_CONF_X] / 10.0;
    here.y = State[STATE_CONF_Y] / 10.0;
    heading = State[STATE_CONF_STEER] / 10.0 * M_PI / 180.0;
    for (i = 0; i < N_SONARS; i++) {
        reading = State[STATE_SONAR_0 + i];
        if (reading == echoes[i].reading)
            continue;
        direction = heading + i * 2.0 * M_PI / N_SONARS;
        echoes[i].reading = reading;
        echoes[i].heard = reading < RANGE + SHELL;
        echoes[i].at.x = here.x + (reading + SHELL) * cos(direction);
        echoes[i].at.y = here.y + (reading + SHELL) * sin(direction);
    }
}

/* Returns the repulsion of all echoes. */
static Vector push(void)
{
    Vector sum = { 0.0, 0.0 };
    const Echo *echo;
    double far, d, force;

    for (echo = echoes; echo < echoes + N_SONARS; echo++) {
        if (!echo->heard)
            continue;
        far = distance(here, echo->at);
        d = fmax(far - SHELL, NEAREST);
        if (d >= RANGE || far == 0.0)
            continue;
        force = STRENGTH * (1.0 / d - 1.0 / RANGE) / (d * d);
        sum.x += force * (here.x - echo->at.x) / far;
        sum.y += force * (here.y - echo->at.y) / far;
    }
    return sum;
}

/* Returns the unit vector towards the goal. */
static Vector pull(Vector goal)
{
    double far = distance(goal, here);
    Vector v = { (goal.x - here.x) / far, (goal.y - here.y) / far };

    return v;
}

/* Drives in the direction of a force. */
static void follow(Vector force)
{
    double turn = normal(atan2(force.y, force.x) - heading);
    double ahead = fmin(State[STATE_SONAR_0], fmin(State[STATE_SONAR_1], State[STATE_SONAR_15]));
    double speed = TOP_SPEED * fmax(0.0, cos(turn));

    speed = fmin(speed, 5.0 * fmax(0.0, ahead - 4.0));
    scout_vm((int) speed, (int) clip(500.0 * turn, TOP_STEER));
}

int main(int argc, char **argv)
{
    Vector goal = { 200.0, 120.0 }, total, away;
    double best, way = 0.0;
    Vector before;
    int loop, since = 0, slide = 0, side = 1, minima = 0;

    if (argc == 3) {
        goal.x = atof(argv[1]);
        goal.y = atof(argv[2]);
    } else if (argc != 1) {
        fprintf(stderr, "usage: potential [x y]\n");
        return 2;
    }
    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "potential: no robot\n");
        return 1;
    }
    conf_tm(2);
    conf_sn(15, order);
    ac(150, 150, 0);
    dp(0, 0);
    da(0, 0);
    usleep(1000000);                       /* until each sonar has fired */
    sense();

    before = here;
    best = distance(goal, here);
    printf("    s       x      y   heading    to go   pull            push\n");
    for (loop = 0; loop < MAX_LOOPS && distance(goal, here) > ARRIVED; loop++) {
        sense();
        if (State[STATE_BUMPER] != 0) {
            printf("bumped at (%.1f, %.1f)\n", here.x, here.y);
            break;
        }
        way += distance(here, before);
        before = here;
        if (distance(goal, here) < best - 0.5) {
            best = distance(goal, here);
            since = loop;
        }
        away = push();
        total = pull(goal);
        if (slide == 0 && (loop - since) * LOOP > STUCK) {
            slide = (int) (SLIDE / LOOP);
            side = total.x * away.y - total.y * away.x > 0.0 ? 1 : -1;
            minima++;
            printf("stuck at (%.1f, %.1f): sliding %s\n", here.x, here.y,
                   side > 0 ? "left" : "right");
        }
        if (slide > 0) {
            double x = away.x;
            away.x = 0.3 * away.x + side * away.y;
            away.y = 0.3 * away.y - side * x;
            if (--slide == 0)
                since = loop;
        }
        if (loop % 50 == 0)
            printf("%5.1f  %6.1f %6.1f   %6.1f   %6.1f   (%4.1f, %4.1f)   (%4.1f, %4.1f)\n",
                   loop * LOOP, here.x, here.y, heading * 180.0 / M_PI, distance(goal, here),
                   total.x, total.y, away.x, away.y);
        total.x += away.x;
        total.y += away.y;
        follow(total);
        usleep((unsigned) (1e6 * LOOP) - 30000);   /* what the two commands leave of it */
    }
    st();
    ws(1, 1, 0, 5);
    sense();
    printf("%s (%.1f, %.1f), %.1f in from the goal, after %.1f in, %d local minima\n",
           distance(goal, here) < 2 * ARRIVED ? "arrived at" : "ended at", here.x, here.y,
           distance(goal, here), way, minima);
    disconnect_robot(ROBOT_ID);
    return distance(goal, here) < 2 * ARRIVED ? 0 : 1;
}
