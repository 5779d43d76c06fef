/*
 * follower.c - follow another robot by sonar; the counterpart of leader.c.
 *
 * The nearest echo ahead is assumed to be the robot in front. Its direction is
 * the mean of the directions of all sonars that measure about the same distance.
 * Speed controls the distance to the leader, and steering keeps the leader
 * straight ahead.
 *
 * Usage:  crs run convoy/convoy.xml          the world names the programs of both robots
 */

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"

#define GAP       24         /* distance to keep, inches */
#define SAME      9          /* maximum difference of echoes of one object, inches */
#define LOST      70         /* no echo within this: no leader, inches */
#define TURNS     500        /* of the loop, 0.1 s each */
#define PATIENCE  40         /* turns that the leader may stand before we take it to be there */

#define N_AHEAD   5

static const struct { int sonar, direction; } ahead[N_AHEAD] = {    /* 0.1 degree */
    { 0, 0 }, { 1, 225 }, { 15, -225 }, { 2, 450 }, { 14, -450 },
};

static int order[16] = { 0, 1, 15, 2, 14, 255 };

static int clip(int value, int low, int high)
{
    return value < low ? low : value > high ? high : value;
}

/* Returns the distance of the leader, and its direction in 0.1 degree. */
static int find_leader(int *direction)
{
    int i, nearest = 255, heard = 0, sum = 0;

    for (i = 0; i < N_AHEAD; i++)
        if (State[STATE_SONAR_0 + ahead[i].sonar] < nearest)
            nearest = State[STATE_SONAR_0 + ahead[i].sonar];
    for (i = 0; i < N_AHEAD; i++)
        if (State[STATE_SONAR_0 + ahead[i].sonar] < nearest + SAME) {
            sum += ahead[i].direction;
            heard++;
        }
    *direction = heard > 0 ? sum / heard : 0;
    return nearest;
}

int main(void)
{
    int turn, distance, direction, speed, steer, standing = 0, nearest = 255, farthest = 0;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    conf_tm(1);
    conf_sn(10, order);
    ac(150, 150, 0);
    dp(0, 0);
    da(0, 0);
    usleep(300000);
    gs();
    for (turn = 0; turn < TURNS && standing < PATIENCE; turn++) {
        distance = find_leader(&direction);
        if (distance < LOST) {
            speed = clip(4 * (distance - GAP) + 30, -40, 110);
            if (abs(distance - GAP) < 3)
                speed = clip(speed, 0, 40);
            steer = clip(direction, -300, 300);
            if (distance < nearest)
                nearest = distance;
            if (distance > farthest)
                farthest = distance;
        } else {
            speed = steer = 0;
        }
        standing = abs(distance - GAP) < 12 && speed < 35 ? standing + 1 : 0;
        scout_vm(speed, steer);
        if (turn % 40 == 0)
            printf("at (%5.1f, %5.1f): %d inches behind, %4.1f degrees, speed %d\n",
                   State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0, distance,
                   direction / 10.0, speed);
        usleep(80000);
    }
    st();
    printf("the leader was %d to %d inches ahead\n", nearest, farthest);
    disconnect_robot(1);
    return 0;
}
