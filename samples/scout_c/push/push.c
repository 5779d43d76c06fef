/*
 * push.c - one of two robots that push a crate too heavy for one.
 *
 * Each drives until a bumper reports the crate, sends a message to the other, and waits
 * for its message. Then both push. They continuously exchange their distances, and the
 * one ahead waits: so the crate moves straight.
 *
 * Usage:  crs run push/push.xml              the world names the program
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define READY    1           /* types of messages */
#define WAY      2
#define SPEED    60          /* 0.1 inch/s */
#define GOAL     800         /* 0.1 inch, to push */
#define AHEAD    5           /* 0.1 inch ahead of the other before waiting */

static int other;            /* the number of the other robot */
static int is_ready, its_way;

static void tell(int type, int value)
{
    crs_send(other, type, &value, sizeof value);
}

/* Processes the messages of the other robot. */
static void listen(void)
{
    struct crs_message message;

    while (crs_receive(&message, 0)) {
        if (message.type == READY)
            is_ready = 1;
        else
            its_way = *(int *)message.data;
    }
}

int main(void)
{
    int start, way = 0, waits = 0;

    other = 1 - crs_my_number();             /* there are two: 0 and 1 */
    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;

    vm(SPEED, SPEED, 0);
    do
        gs();
    while (!State[STATE_BUMPER]);
    st();
    tell(READY, 0);
    printf("at the crate after %d.%d in\n", (int)State[STATE_CONF_X] / 10,
           (int)State[STATE_CONF_X] % 10);
    while (!is_ready) {
        usleep(50000);
        listen();
    }

    gs();
    start = State[STATE_CONF_X];
    while (way < GOAL) {
        listen();
        if (way > its_way + AHEAD) {
            vm(0, 0, 0);
            waits++;
        } else {
            vm(SPEED, SPEED, 0);
        }
        usleep(100000);
        gs();
        way = State[STATE_CONF_X] - start;
        tell(WAY, way);
    }
    tell(WAY, GOAL + AHEAD);
    st();
    printf("pushed %d.%d in, waited %s\n", way / 10, way % 10, waits > 0 ? "for the other" : "never");
    return 0;
}
