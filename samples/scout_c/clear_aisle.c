/*
 * clear_aisle.c - pushes obstacles to the end of an aisle.
 *
 * The robot drives ahead until a bumper closes, and continues pushing. Every thirty
 * inches it prints the distance; it detects the object only by its bumper. If it makes no
 * progress for two seconds, or after MOST inches, it backs off.
 *
 *     crs run clear_aisle.c warehouse.xml
 */
#include <stdio.h>
#include "Nclient.h"

#define SPEED    100            /* 0.1 inch/s */
#define MOST     150            /* inches */
#define PATIENCE 80             /* readings without an inch of progress */

enum { FREE, PUSHING, STUCK };

static const char *const doing[] = { "free", "pushing", "stuck" };

/* Returns the distance driven, in inches. */
static long way(void)
{
    return State[STATE_CONF_X] / 10;
}

int main(void)
{
    int state = FREE, still = 0, touched = 0;
    long best = 0, said = 0;

    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    scout_vm(SPEED, 0);
    while (best < MOST && still < PATIENCE) {
        gs();
        if (way() > best) {
            best = way();
            still = 0;
        } else {
            still++;
        }
        state = State[STATE_BUMPER] ? PUSHING : FREE;
        touched += state == PUSHING;
        if (best >= said + 30) {
            said = best / 30 * 30;
            printf("%3ld in: %s\n", said, doing[state]);
        }
    }
    if (still >= PATIENCE)
        state = STUCK;
    printf("%s after %ld in, touched something: %s\n", doing[state], best,
           touched ? "yes" : "no");
    scout_vm(-SPEED, 0);                        /* leave it where it is */
    while (way() > best - 12)
        gs();
    st();
    ws(1, 1, 0, 5);
    disconnect_robot(1);
    return 0;
}
