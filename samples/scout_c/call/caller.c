/*
 * caller.c - call with one tone until another robot answers nearby with a second tone.
 *
 * The other half is seeker.c.
 *
 * Usage:  crs run call/call.xml              the world names the programs of both robots
 */

#include <stdio.h>
#include <unistd.h>
#include "crs.h"

#define TONES    8
#define HELP     3
#define HERE     5
#define LOUD     500
#define NEAR     200         /* level of an answer from nearby */

int main(void)
{
    int level[TONES], direction, n;

    crs_sound(LOUD, HELP);
    for (n = 0; n < 1800; n++) {
        usleep(100000);
        if (crs_get_sound(level, TONES, &direction) == TONES && level[HERE] > NEAR) {
            crs_sound(0, HELP);
            printf("answered after %d s, from %d degrees\n", n / 10, direction / 10);
            return 0;
        }
    }
    printf("nobody came\n");
    return 1;
}
