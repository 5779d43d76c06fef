/*
 * seek_tag.c - one of any number of robots that seek hot objects and tag them.
 *
 * The robot drives in legs of ten inches. Before each leg it measures the heat around it, and tags
 * if there is any. Then it turns towards the freer side until the way is free: of walls, objects
 * and other robots, which are all the same to its sonars. The robots do not talk to each other.
 *
 *     crs run seek_tag.c heat.xml
 */

#include <stdlib.h>

int LEG = 100;          /* 0.1 inch */
int TURN = 300;         /* 0.1 degree */

#ifndef NEAR
#define NEAR 200        /* 0.1 inch; sonars measure from the robot's rim */
#endif

/* Returns a sonar reading, a large one if there is no echo. */
int reading(int sonar)
{
    int tenths = State[STATE_SONAR_0 + sonar];

    return tenths == -1 ? 10000 : tenths;
}

int nearest(int a, int b, int c)
{
    int best = reading(a);

    if (reading(b) < best)
        best = reading(b);
    return reading(c) < best ? reading(c) : best;
}

void feel()
{
    heatSensorCheck();
    if (State[STATE_HEAT] > 0)
        tagTarget();
}

/* Returns whether the next leg ends before any obstacle, and passes those at the sides. */
int is_free()
{
    return nearest(15, 0, 1) > NEAR && nearest(2, 14, 0) > 2 * NEAR / 3 && nearest(3, 13, 0) > NEAR / 4;
}

/* Turns at random now and then, so as not to drive the same round for ever. */
void roam()
{
    if (rand() % 6 == 0) {
        scout_pr(0, rand() % 1800 - 900);
        ws(1, 1, 0, 255);
    }
}

/* Turns until the way ahead is free, at most once around. */
void look()
{
    int left, right, turns;

    sonarSensorCheck();
    left = nearest(1, 2, 3);
    right = nearest(15, 14, 13);
    for (turns = 0; turns < 12 && !is_free(); turns++) {
        scout_pr(0, left > right ? -TURN : TURN);       /* to the right is positive */
        ws(1, 1, 0, 255);
        sonarSensorCheck();
    }
}

void runcode()
{
    int sonar, sum = 0;

    connect_robot(1, MODEL_SCOUT, "localhost", 8000);
    sonarSensorCheck();
    for (sonar = 0; sonar < 16; sonar++)
        sum += State[STATE_SONAR_0 + sonar];
    srand(sum);                                 /* of noisy readings: another one for each seed */
    for (;;) {
        feel();
        roam();
        look();
        pr(LEG, LEG, 0);
        ws(1, 1, 0, 255);
        get_bp();
        if (State[STATE_BUMPER]) {              /* into an obstacle that no sonar detected */
            pr(-LEG, -LEG, 0);
            ws(1, 1, 0, 255);
        }
    }
}
