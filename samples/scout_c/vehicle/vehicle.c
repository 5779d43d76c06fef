/*
 * vehicle.c - a Braitenberg vehicle that approaches a light.
 *
 * Each light sensor drives the wheel of the other side: the more light on the left, the
 * faster the right wheel, and so the vehicle turns to the light and gets faster the
 * brighter it is (V. Braitenberg, "Vehicles", 1984, number 2b). Brightness falls with the
 * square of the distance, so its root is used. If a bumper is pressed it turns aside;
 * where it is bright enough, it stops.
 *
 * Usage:  crs run vehicle/vehicle.xml        the world names the program
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define EYES      8          /* counter-clockwise, number 0 in front */
#define BRIGHT    600        /* level at which to stop */
#define IDLE      20.0       /* 0.1 inch/s, in the dark */
#define GAIN      12.0       /* 0.1 inch/s, for the root of the light */
#define FASTEST   200.0

/* Returns the amount of light from one side, front to back. */
static double side(const int *eye, int first)
{
    return sqrt(eye[first] + eye[first + 1] + eye[first + 2]);
}

static int wheel(double light)
{
    double speed = IDLE + GAIN * light;

    return (int)(speed > FASTEST ? FASTEST : speed);
}

int main(void)
{
    int eye[EYES], n, bumps = 0, brightest = 0;
    double left, right;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    for (n = 0; n < 1200 && brightest < BRIGHT; n++) {
        if (crs_get_light(eye, EYES) != EYES)
            return 1;
        left = side(eye, 1);                 /* 45, 90 and 135 degrees */
        right = side(eye, 5);                /* 225, 270 and 315 */
        vm(wheel(left), wheel(right), 0);
        brightest = eye[0];
        if (n % 20 == 0)
            printf("%5.1f s: left %4.1f, right %4.1f, ahead %d\n", n / 10.0, left, right, eye[0]);
        gs();
        if (State[STATE_BUMPER]) {
            bumps++;
            pr(-100, -100, 0);
            ws(1, 1, 0, 5);
            pr(80, -80, 0);
            ws(1, 1, 0, 5);
        }
        usleep(100000);
    }
    st();
    printf("%s at %d, %d in, bumped %d times\n", brightest >= BRIGHT ? "light" : "dark",
           (int)State[STATE_CONF_X] / 10, (int)State[STATE_CONF_Y] / 10, bumps);
    return brightest >= BRIGHT ? 0 : 1;
}
