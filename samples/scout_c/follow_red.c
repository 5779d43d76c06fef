/*
 * follow_red.c - drives to a red object by camera: visual servoing.
 *
 * The robot turns until a red blob is in the picture, then steers to keep it centred,
 * slows down as it approaches, and stops in front of it.
 *
 * Usage:  crs run follow_red.c gallery.xml
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define RED        0xff0000
#define MAX_BLOBS  32
#define SPEED      120          /* 0.1 inch/s */
#define SLOW       40
#define NEAR       150          /* from the camera, 0.1 inch */
#define GAIN       4            /* 0.1 degree per 0.1 inch/s of wheel speed difference */
#define PERIOD     100000       /* microseconds */
#define MAX_TURNS  600

/* Finds the widest blob of a colour; returns 0 if there is none. */
static int find(int colour, struct crs_blob *found)
{
    struct crs_blob blobs[MAX_BLOBS];
    int i, count = crs_blobs(blobs, MAX_BLOBS);

    found->width = 0;
    for (i = 0; i < count; i++)
        if (blobs[i].colour == colour && blobs[i].width > found->width)
            *found = blobs[i];
    return found->width > 0;
}

int main(void)
{
    struct crs_blob red;
    int turns, steps = 0, seen = 0, ahead, turn;

    if (!connect_robot(1))
        return 1;
    for (turns = 0; turns < MAX_TURNS; turns++, usleep(PERIOD)) {
        if (!find(RED, &red)) {
            vm(SLOW, -SLOW, 0);                  /* look around, to the left */
            continue;
        }
        if (!seen) {
            printf("red at %d.%d degrees, %d in away\n", red.angle / 10, red.angle % 10,
                   red.range / 10);
            seen = 1;
        }
        if (red.range <= NEAR)
            break;
        ahead = red.range > 4 * NEAR ? SPEED : SLOW + (SPEED - SLOW) * (red.range - NEAR) / (3 * NEAR);
        turn = red.angle / GAIN;
        vm(ahead + turn, ahead - turn, 0);
        steps++;
    }
    st();
    ws(1, 1, 0, 10);
    if (turns == MAX_TURNS || !find(RED, &red)) {
        printf("no red thing found\n");
        return 1;
    }
    printf("stopped %d in before it, %d degrees wide, after %d steps\n", red.range / 10,
           red.width / 10, steps);
    disconnect_robot(1);
    return 0;
}
