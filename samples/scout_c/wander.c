/*
 * wander.c - let a Scout wander through a room without collisions.
 *
 * The robot cruises while there is room ahead, slows down and bends away from
 * what comes near on one side, and when the way is blocked turns in place
 * until it is free again. If a bumper closes all the same it backs off first.
 * One line is printed when the state changes, and one every 50 steps:
 *
 *     step  state    x      y   heading   front left right   speed steer
 *
 * with inches and degrees; speed and steer are what was sent to scout_vm().
 *
 * Usage:  crs run wander.c room.xml            2400 steps
 *         crs run wander.c room.xml -- 500     500 steps
 *
 * The language is the C of its time: gcc -traditional or -std=gnu89.
 */

#include <stdio.h>
#include "Nclient.h"

# define ROBOT_ID     1
# define MAX_STEPS    2400
# define N_SONARS     16
# define NO_ECHO      255             /* the longest reading, inches */

/* Distances to obstacles, inches */
# define STOP_DIST    13              /* too close to continue */
# define CLEAR_DIST   26              /* free enough to start again */
# define SLOW_DIST    45              /* begin to slow down */
# define SIDE_DIST    15              /* distance to keep from walls beside */

/* Speeds, arguments of scout_vm(): 0.1 inch/s and 0.1 degree/s */
# define MAX_SPEED    150
# define MIN_SPEED    30
# define BACK_SPEED   (-60)
# define MAX_STEER    350
# define SPIN         300

/* Steps of the control loop, each about 23 ms on a line of 38400 baud */
# define BACK_STEPS   50
# define PATIENCE     35              /* steps after which to require an inch less */
# define MAX_SPIN     800             /* two full turns */

# define MIN(a,b)     ((a) < (b) ? (a) : (b))
# define MAX(a,b)     ((a) > (b) ? (a) : (b))
# define CLIP(v,m)    MAX(-(m), MIN((v), (m)))
# define S(i)         (ring[(i) & (N_SONARS - 1)])   /* sonar i, also for i < 0 */
# define TENTHS(v)    ((v) / 10.0)

enum { CRUISE, TURN, BACK };
char *state_name[] = { "cruise", "turn", "back" };

int order[N_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };
int ring[N_SONARS];                   /* the newest reading of each sonar, inches */
int front, left, right;               /* nearest echo ahead and on each side */
int state = CRUISE, since;            /* current state, and its first step */
int turn_sign = 1;                    /* 1 turns left, -1 turns right */
int speed, steer;

/* Copies the readings out of the State vector, since the next command changes it. */
copy_ring(from, to)
    register long *from;
    register int *to;
{
    int *end = to + N_SONARS;

    while (to < end)
        *to++ = *from++;
}

/* Returns the nearest of the sonars first..last, counted counter-clockwise. */
nearest(first, last)
{
    int i, best = NO_ECHO;

    for (i = first; i <= last; i++)
        if (S(i) < best)
            best = S(i);
    return best;
}

look()
{
    get_sn();
    copy_ring(&State[STATE_SONAR_0], ring);
    front = nearest(-1, 1);
    front = MIN(front, 2 * MIN(S(2), S(-2)));   /* leave room for the shoulders */
    left = nearest(2, 5);
    right = nearest(-5, -2);
}

report(step)
{
    printf("%5d  %-6s %6.1f %6.1f  %6.1f    %4d %4d %4d    %4d %5d\n",
           step, state_name[state],
           TENTHS(State[STATE_CONF_X]), TENTHS(State[STATE_CONF_Y]),
           TENTHS(State[STATE_CONF_STEER]), front, left, right, speed, steer);
}

enter(new_state, step)
{
    state = new_state;
    since = step;
}

/* Forward, slower the nearer the next thing is, and away from the nearer side. */
cruise(step)
{
    int push;

    if (front <= STOP_DIST) {
        /* turn to the more open half; the choice stands until we are free */
        turn_sign = nearest(1, 6) >= nearest(-6, -1) ? 1 : -1;
        speed = steer = 0;
        enter(TURN, step);
        return;
    }
    speed = MAX_SPEED;
    if (front < SLOW_DIST)
        speed = MIN_SPEED + (MAX_SPEED - MIN_SPEED) * (front - STOP_DIST)
                            / (SLOW_DIST - STOP_DIST);
    push = 0;
    if (left < SIDE_DIST)
        push -= 25 * (SIDE_DIST - left);
    if (right < SIDE_DIST)
        push += 25 * (SIDE_DIST - right);
    if (front < SLOW_DIST)            /* steer early towards the open side */
        push += S(1) + S(2) > S(-1) + S(-2) ? 80 : -80;
    steer = CLIP(push, MAX_STEER);
    if (MIN(left, right) < SIDE_DIST / 2)
        speed = MIN_SPEED;
}

/* Turns in place until the way ahead is free; requires less room over time. */
turn(step)
{
    speed = 0;
    steer = turn_sign * SPIN;
    if (front >= MAX(CLEAR_DIST - (step - since) / PATIENCE, STOP_DIST + 2)) {
        steer = 0;
        enter(CRUISE, step);
    } else if (step - since > MAX_SPIN)
        enter(BACK, step);
}

/* Backs off, unless the way behind is blocked, then turns. */
back(step)
{
    speed = nearest(7, 9) > STOP_DIST / 2 ? BACK_SPEED : 0;
    steer = 0;
    if (step - since > BACK_STEPS) {
        turn_sign = -turn_sign;
        enter(TURN, step);
    }
}

int (*act[])() = { cruise, turn, back };

main(argc, argv)
    char **argv;
{
    int step, max_steps = MAX_STEPS, old_state = -1, bumps = 0;

    if (argc > 1)
        max_steps = atoi(argv[1]);
    if (connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400) == FALSE) {
        printf("wander: cannot connect\n");
        exit(1);
    }
    conf_tm(5);
    conf_sn(15, order);               /* one sonar every 60 ms, all in 0.96 s */
    ac(200, 200, 0);
    dp(0, 0);
    da(0, 0);
    for (step = 0; step < 64; step++)
        gs();                         /* until each sonar has fired once */

    printf(" step  state       x      y heading   front left right   speed steer\n");
    for (step = 0; step < max_steps; step++) {
        look();
        if (State[STATE_BUMPER] && state != BACK) {
            bumps++;
            enter(BACK, step);
        }
        (*act[state])(step);
        scout_vm(speed, steer);
        if (state != old_state || step % 50 == 0)
            report(step);
        old_state = state;
    }

    st();
    ws(1, 1, 0, 5);
    printf("%d steps, %d bumps, stopped at (%.1f, %.1f)\n", step, bumps,
           TENTHS(State[STATE_CONF_X]), TENTHS(State[STATE_CONF_Y]));
    disconnect_robot(ROBOT_ID);
    return 0;
}
