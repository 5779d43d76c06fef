/*
 * follower.c - follow a leader: drive as fast as it says.
 */

#include <stdio.h>
#include <string.h>
#include <crs.h>
#include "Nclient.h"

#define SPEED     7          /* type of a message: an int, 0.1 inch/s */
#define TURNS     300        /* of the loop, about 0.1 s each */

static struct {
    int speed;               /* of the leader, 0.1 inch/s */
    int heard;               /* messages */
} told;

static void listen(int milliseconds)
{
    struct crs_message message;

    if (crs_receive(&message, milliseconds) && message.type == SPEED) {
        memcpy(&told.speed, message.data, sizeof told.speed);
        told.heard++;
    }
}

int main(void)
{
    int turn, speed;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    ac(300, 300, 0);
    for (turn = 0; turn < TURNS; turn++) {
        listen(80);
        speed = told.speed;
        scout_vm(speed, 0);
    }
    printf("%d messages\n", told.heard);
    disconnect_robot(1);
    return 0;
}
