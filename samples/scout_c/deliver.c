/*
 * deliver.c - pushes a crate to a dock, and comes back.
 *
 * The bumpers tell when the robot has come to the crate; from there on odometry tells
 * how far it has been pushed. The goals of the world say where the dock is.
 *
 * Usage:  crs run deliver.c delivery.xml --summary
 */

#include <stdio.h>
#include "Nclient.h"

#define SPEED  100        /* 0.1 inch/s */
#define PUSH   780        /* from the crate to the dock, 0.1 inch */

int main(void)
{
    long crate, dock;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    conf_tm(0);
    ac(200, 200, 0);
    sp(SPEED, SPEED, 0);

    vm(SPEED, SPEED, 0);
    do
        gs();
    while (!State[STATE_BUMPER]);
    crate = State[STATE_CONF_X];
    printf("at the crate after %ld in\n", crate / 10);

    while (State[STATE_CONF_X] < crate + PUSH)
        gs();
    st();
    ws(1, 1, 0, 10);
    get_rc();
    dock = State[STATE_CONF_X];
    printf("at the dock after %ld in\n", dock / 10);

    scout_pr((int)-dock, 0);
    ws(1, 1, 0, 60);
    get_rc();
    printf("back at %ld in\n", State[STATE_CONF_X] / 10);
    disconnect_robot(1);
    return 0;
}
