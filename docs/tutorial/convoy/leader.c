/*
 * leader.c - lead a convoy: drive a course, and tell the follower every change of speed.
 */

#include <unistd.h>
#include <crs.h>
#include "Nclient.h"

#define FOLLOWER  1
#define SPEED     7          /* type of a message: an int, 0.1 inch/s */

struct leg {
    int speed;               /* 0.1 inch/s */
    int seconds;
};

static const struct leg course[] = {
    { 100, 4 }, { 60, 3 }, { 140, 4 }, { 80, 3 }, { 0, 2 }, { 120, 3 }, { 0, 4 },
};

static void drive(int speed)
{
    crs_send(FOLLOWER, SPEED, &speed, sizeof speed);
    scout_vm(speed, 0);
}

int main(void)
{
    unsigned i;

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    ac(300, 300, 0);
    for (i = 0; i < sizeof course / sizeof *course; i++) {
        drive(course[i].speed);
        sleep(course[i].seconds);
    }
    disconnect_robot(1);
    return 0;
}
