/*
 * sense.c - measuring with the sonar ring.
 */

# include "patrol.h"

# define RATE         15           /* 60 ms from sonar to sonar */
# define ROUND        1000000      /* so that all have fired, microseconds */
# define DEEP         50           /* beyond a closed door, inches */

static int order[N_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };

start_sonars()
{
    conf_sn(RATE, order);
    usleep(ROUND);
}

/* Waits for readings of all sonars, stores them, and returns the one straight ahead. */
look()
{
    register int i;

    usleep(ROUND);
    get_sn();
    for (i = 0; i < N_SONARS; i++)
        ring[i] = State[STATE_SONAR_0 + i];
    return ring[0];
}

/* Returns whether the way ahead was free in the last ring. */
clear_ahead()
{
    return ring[0] > DEEP;
}

char *
state_name(state)
{
    static char *names[] = { "unknown", "OPEN", "closed" };

    return names[state];
}
