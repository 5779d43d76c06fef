/*
 * warmer.c - finds a stove by its heat: run and tumble, like bacteria.
 *
 * The heat sensor has no direction. While the heat increases, the robot continues; if it
 * decreases, or the way is blocked, it turns and tries another direction.
 *
 * Usage:  crs run warmer.c gallery.xml
 */

#include <stdio.h>
#include "Nclient.h"
#include "crs.h"

#define STEP       120          /* 0.1 inch */
#define TURN       700          /* 0.1 degree */
#define HOT        900
#define NEAR       14           /* inches */
#define MAX_STEPS  400
#define TIMEOUT    10           /* seconds */

static void turn(int angle)
{
    int way = (int)(angle * 0.118597);

    pr(way, -way, 0);
    ws(1, 1, 0, TIMEOUT);
}

static int is_free(void)
{
    get_sn();
    return State[STATE_SONAR_0] > NEAR && State[STATE_SONAR_1] > NEAR / 2
        && State[STATE_SONAR_15] > NEAR / 2;
}

int main(void)
{
    int heat, before, steps, tumbles = 0;

    if (!connect_robot(1) || !crs_heat(&before))
        return 1;
    sp(200, 200, 0);
    ac(400, 400, 0);
    printf("it begins at %d\n", before);
    for (steps = 0; steps < MAX_STEPS && before < HOT; steps++) {
        if (is_free()) {
            pr(STEP, STEP, 0);
            ws(1, 1, 0, TIMEOUT);
        } else
            turn(TURN);
        crs_heat(&heat);
        if (heat < before) {
            turn(TURN);
            tumbles++;
        }
        before = heat;
    }
    printf("%d after %d steps, of which %d led away from it\n", before, steps, tumbles);
    disconnect_robot(1);
    return before < HOT;
}
