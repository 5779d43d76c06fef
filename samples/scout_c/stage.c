/*
 * stage.c - the edge of a stage, seen from below and from above.
 *
 * From the floor, the edge of a plateau is a wall: the front sonar measures its distance,
 * and the robot stops in front of it. From above it is invisible: the sonar's beam passes
 * over the edge, and only the encoders determine where to stop.
 *
 * The robot drives up a ramp to the left, whose position it knows.
 *
 * Usage:  crs run stage.c plateau.xml
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID  1
#define SPEED     150            /* 0.1 inch/s */
#define NEAR      10             /* inches */
#define PERIOD    100000         /* microseconds */
#define MAX_TURNS 300
#define TIMEOUT   60             /* seconds */
#define STAGE     1570           /* from one end of the stage to the other, 0.1 inch */
#define RAMP      997            /* length of the ramp along the ground */

static int order[16] = { 0, 1, 15, 255 };

static void go(int way)
{
    pr(way, way, 0);
    ws(1, 1, 0, TIMEOUT);
}

/* Turns in place by an angle, 0.1 degree. */
static void turn(int angle)
{
    int way = (int)(angle * 0.118597);

    pr(way, -way, 0);
    ws(1, 1, 0, TIMEOUT);
}

static int ahead(void)
{
    usleep(3 * PERIOD);
    get_sn();
    return (int)State[STATE_SONAR_0];
}

int main(void)
{
    int turns, came;

    if (!connect_robot(ROBOT_ID))
        return 1;
    conf_sn(15, order);
    ac(300, 300, 0);
    sp(SPEED, SPEED, 0);

    printf("from the floor: %d in to the edge\n", ahead());
    vm(SPEED, SPEED, 0);
    for (turns = 0; turns < MAX_TURNS; turns++) {
        usleep(PERIOD);
        get_sn();
        if (State[STATE_SONAR_0] <= NEAR)
            break;
    }
    st();
    ws(1, 1, 0, TIMEOUT);
    get_rc();
    came = (int)State[STATE_CONF_X];
    printf("stopped %d in before it, after %d in\n", ahead(), came / 10);

    go(-came);
    turn(900);
    go(787);                     /* to the centre of the ramp */
    turn(-900);
    go(200 + RAMP);
    printf("on the stage: %d in to what the sonar sees\n", ahead());
    go(STAGE - 150);
    get_bp();
    printf("at the other end: %d in, and a drop before the wheels that nothing tells of\n",
           ahead());
    disconnect_robot(ROBOT_ID);
    return 0;
}
