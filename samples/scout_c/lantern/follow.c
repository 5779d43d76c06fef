/*
 * follow.c - follows a light at a distance, and stops where it goes out.
 *
 * It turns to the brighter side, and drives more slowly in brighter light: brightness
 * falls with the square of the distance, so above NEAR the lamp is close enough.
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define EYES 8               /* counter-clockwise, number 0 in front */
#define NEAR 300
#define DARK 30              /* tenths of a second without light until it gives up */

int main(void)
{
    int eye[EYES], n, left, right, all, speed, turn, dark = 0, brightest = 0;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    for (n = 0; n < 3000 && dark < DARK; n++) {
        if (crs_get_light(eye, EYES) != EYES)
            return 1;
        left = eye[1] + eye[2] + eye[3];
        right = eye[5] + eye[6] + eye[7];
        all = left + right + eye[0] + eye[4];
        dark = all ? 0 : dark + 1;
        if (all > brightest)
            brightest = all;
        turn = all ? 60 * (left - right) / all : 0;
        speed = all == 0 || eye[0] > NEAR ? 0 : 80;
        vm(speed + turn, speed - turn, 0);
        usleep(100000);
    }
    st();
    gs();
    printf("dark at %d, %d in; the most light was %d\n", (int)State[STATE_CONF_X] / 10,
           (int)State[STATE_CONF_Y] / 10, brightest);
    return 0;
}
