/*
 * motion.c - driving along the corridor, whose direction is heading 0.
 */

# include "patrol.h"

# define SPEED        100          /* 0.1 inch/s */
# define NEAR         12           /* obstacle ahead: stop, inches */
# define MAX_CALLS    1500

start_motion()
{
    conf_tm(5);
    ac(150, 150, 0);
    sp(SPEED, SPEED, 0);
    dp(0, 0);
    da(0, 0);
}

halt()
{
    st();
    return ws(1, 1, 0, 5);
}

/* Returns the smaller turn from one direction to another, 0.1 degree. */
static smaller(turn)
{
    while (turn > 1800)
        turn -= 3600;
    while (turn <= -1800)
        turn += 3600;
    return turn;
}

/* Turns in place to an angle from the corridor's direction. */
face(degrees)
{
    get_rc();
    scout_pr(0, smaller(DEGREES(degrees) - (int) State[STATE_CONF_STEER]));
    return ws(1, 1, 0, 20);
}

/* Drives to a point on the corridor's axis, forward or backward; FALSE if it cannot. */
go_to(where)
    long where;
{
    long rest;
    int sign, calls, steer;

    for (calls = 0; calls < MAX_CALLS; calls++) {
        gs();
        rest = where - State[STATE_CONF_X];
        if (labs(rest) < 10)
            break;
        if (State[STATE_BUMPER]) {
            bumps++;
            break;
        }
        sign = rest > 0 ? 1 : -1;
        if (State[sign > 0 ? STATE_SONAR_0 : STATE_SONAR_8] < NEAR)
            break;
        /* steer back to the axis */
        steer = smaller(-sign * (int) State[STATE_CONF_Y] * 3 - (int) State[STATE_CONF_STEER]);
        if (labs(rest) > SPEED)
            scout_vm(sign * SPEED, steer);
        else
            scout_vm(sign * (20 + (int) labs(rest) / 2), steer);
        usleep(40000);
    }
    halt();
    get_rc();
    return labs(where - State[STATE_CONF_X]) < 20;
}
