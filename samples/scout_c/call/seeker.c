/*
 * seeker.c - find a caller by sound; the counterpart of caller.c.
 *
 * The robot turns to the direction of the call and drives there. Behind a wall the call
 * is weak and the way is blocked: if a bumper is pressed, the robot backs away and
 * follows the wall for a while, always on the same side, before it listens again. Where
 * the call is loud enough, it answers.
 *
 * Usage:  crs run call/call.xml              the world names the programs of both robots
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define TONES    8
#define HELP     3
#define HERE     5
#define NEAR     450         /* level at which the caller has been found */
#define ANSWER   500
#define CRUISE   120         /* 0.1 inch/s */
#define ASIDE    400         /* 0.1 inch, along a wall */

static void turn(int direction)              /* 0.1 degree, to the left */
{
    int way = direction * 1186 / 10000;

    pr(way, -way, 0);
    ws(1, 1, 0, 20);
}

static void drive(int way)
{
    pr(way, way, 0);
    ws(1, 1, 0, 20);
}

static int clip(int value, int most)
{
    return value < -most ? -most : value > most ? most : value;
}

int main(void)
{
    int level[TONES], direction, steer, n, bumps = 0, loudest = 0;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    for (n = 0; n < 1500 && loudest < NEAR; n++) {
        if (crs_get_sound(level, TONES, &direction) != TONES)
            return 1;
        loudest = level[HELP];
        if (n % 50 == 0)
            printf("call %3d from %4d degrees\n", loudest, direction / 10);
        gs();
        if (State[STATE_BUMPER]) {
            bumps++;
            drive(-60);
            turn(direction > 0 ? -1000 + direction : -800 + direction);
            drive(ASIDE);
        } else if (direction > 450 || direction < -450) {
            turn(direction);
        } else {
            steer = clip(direction / 6, 60);
            vm(CRUISE + steer, CRUISE - steer, 0);
        }
        usleep(100000);
    }
    st();
    if (loudest < NEAR) {
        printf("lost\n");
        return 1;
    }
    crs_sound(ANSWER, HERE);
    printf("found it after %d walls\n", bumps);
    sleep(1);
    return 0;
}
