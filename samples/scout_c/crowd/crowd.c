/*
 * crowd.c - robots that start in a crowd spread out: each drives away from what is near.
 *
 * Each echo pushes the robot, the more the nearer it is. The robot turns where the sum of all
 * pushes points, and stops when nothing is near.
 *
 * Usage:  crs run crowd.xml
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

#define NEAR    50.0            /* inches: echoes from farther away do not push */
#define SPEED   60.0            /* 0.1 inch per second */
#define STEPS   150

static double ahead, left;

static void push(void)
{
    int i;

    ahead = left = 0;
    for (i = 0; i < 16; i++) {
        double near = 1 - State[STATE_SONAR_0 + i] / NEAR, angle = i * 2 * M_PI / 16;

        if (near > 0) {
            ahead -= near * cos(angle);
            left -= near * sin(angle);
        }
    }
}

int main(void)
{
    int step;

    if (!connect_robot(1))
        return 1;
    conf_tm(2);
    for (step = 0; step < STEPS; step++) {
        double speed, turn;

        get_sn();
        push();
        speed = ahead > 0 && fabs(left) < ahead ? SPEED : 0;
        turn = hypot(ahead, left) > 0.1 ? SPEED / 2 * (left > 0 ? 1 : -1) : 0;
        if (speed > 0)
            turn *= fabs(left) / ahead;
        vm((int)(speed + turn), (int)(speed - turn), 0);
        usleep(200000);
    }
    st();
    get_sn();
    push();
    printf("pushed by %.1f\n", hypot(ahead, left));
    return 0;
}
