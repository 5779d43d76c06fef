/*
 * ants.c - a scout ant lays a trail of pheromone to the food, and others follow it.
 *
 * The followers know nothing of the way: each turns to the side on which its antennae smell more,
 * and stops where both smell nothing any more.
 *
 * Usage:  crs run ants.xml
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define SPEED    60             /* 0.1 inch per second */
#define TURN     60             /* the same, at most, added to one wheel */
#define TRAIL    1000.0         /* per metre */
#define PERIOD   50000          /* microseconds */
#define LOST     4              /* periods without a smell */
#define ON_RIGHT 0              /* antennae */
#define ON_LEFT  1

static const struct {
    int right, left;            /* wheels, 0.1 inch per second */
    double seconds;
} way[] = {
    { 60, 60, 6.0 }, { 63, 57, 5.0 }, { 60, 60, 5.0 }, { 57, 63, 8.0 }, { 60, 60, 3.0 },
};

static void scout(int trail)
{
    unsigned leg;

    crs_lay_trail(trail, TRAIL);
    for (leg = 0; leg < sizeof way / sizeof way[0]; leg++) {
        vm(way[leg].right, way[leg].left, 0);
        usleep((unsigned)(way[leg].seconds * 1e6));
    }
    crs_lay_trail(trail, 0);
    vm(SPEED, SPEED, 0);        /* out of the way of the others */
    sleep(3);
    st();
    printf("food found\n");
}

static void follow(int trail)
{
    int lost = 0, turn;
    double right, left, most = 0;

    sleep(4);                   /* until there is a trail to walk to */
    vm(SPEED, SPEED, 0);
    while (most == 0 || lost < LOST) {
        usleep(PERIOD);
        right = crs_smell(trail, ON_RIGHT);
        left = crs_smell(trail, ON_LEFT);
        if (right + left == 0) {
            lost++;
            continue;
        }
        lost = 0;
        most = right + left > most ? right + left : most;
        turn = (int)(TURN * (left - right) / (left + right));
        vm(SPEED + turn, SPEED - turn, 0);
    }
    vm(SPEED, SPEED - 10, 0);   /* out of the way of the next one */
    sleep(3);
    st();
    printf("the trail ends; it smelled of %.1f at most\n", most);
}

int main(int argc, char **argv)
{
    int trail = crs_find_field("trail");

    (void)argv;
    if (!connect_robot(1) || trail < 0)
        return 1;
    if (argc > 1)
        scout(trail);
    else
        follow(trail);
    return 0;
}
