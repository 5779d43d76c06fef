/* Looks for the nearest sonar, and at one more than there are. */
#include <stdio.h>
#include "Nclient.h"

static int closest(long *sonar, int count)
{
    int i, best = 0;

    for (i = 0; i <= count; i++)
        if (sonar[i] < sonar[best])
            best = i;
    return best;
}

int main(void)
{
    long ring[16];
    int i;

    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 16; i++)
        ring[i] = State[STATE_SONAR_0 + i];
    printf("sonar %d is the closest\n", closest(ring, 16));
    return 0;
}
