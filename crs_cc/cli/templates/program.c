/*
 * NAME.c - drives ahead, and turns away from obstacles.
 *
 *     crs check NAME.c
 *     crs run NAME.c WORLD.xml --plot run.svg
 *
 * docs/robot-api.md documents all functions. Lengths are in 0.1 inch and angles in 0.1 degree,
 * but sonar readings are in inches.
 */
#include <stdio.h>
#include "Nclient.h"

#define NEAR   25               /* inches */
#define STEPS  400

/* Returns the nearest of the three front sonar readings, in inches. */
static long ahead(void)
{
    long best = State[STATE_SONAR_0];

    if (State[STATE_SONAR_1] < best)
        best = State[STATE_SONAR_1];
    if (State[STATE_SONAR_15] < best)
        best = State[STATE_SONAR_15];
    return best;
}

int main(void)
{
    int step;

    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (step = 0; step < STEPS; step++) {
        gs();                                   /* reads everything into State[] */
        if (State[STATE_BUMPER])
            scout_vm(-50, 0);                   /* back off, 5 inches a second */
        else if (ahead() > NEAR)
            scout_vm(100, 0);                   /* ahead, 10 inches a second */
        else
            scout_vm(0, 450);                   /* turn to the left, 45 degrees a second */
    }
    st();
    ws(1, 1, 0, 10);
    get_rc();
    printf("at x = %.1f, y = %.1f inches\n", State[STATE_CONF_X] / 10.0,
           State[STATE_CONF_Y] / 10.0);
    disconnect_robot(1);
    return 0;
}
