/*
 * cluster.c - one of some robots that push pucks together, though none knows where others lie.
 *
 * A robot drives straight ahead, or to the nearest puck that its camera sees, and so keeps in front
 * of it the one that it pushes. It leaves that where it sees another one beside it, or where its
 * wheels stop, because there are more than its motors can push: it backs off, and turns at random.
 * So a puck comes to lie where others do, and it is left in peace there: pucks that lie together are
 * more than one from the beginning. Walls and other robots make a robot turn at random, too; what it
 * pushes it leaves so far from them that it can be fetched again. After
 *
 *     R. Beckers, O. E. Holland and J. L. Deneubourg, From local actions to global tasks: stigmergy
 *     and collective robotics, Artificial Life IV (1994),
 *
 * whose robots had a switch for "more than two", and no camera.
 *
 * Usage:  crs run clustering.xml
 */

#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#ifndef LEAVE
#define LEAVE    1              /* whether it leaves a puck with others */
#endif

#define SPEED    80             /* 0.1 inch/s */
#define TURN     60             /* 0.1 inch/s of a wheel, per radian */
#define SPIN     39             /* 0.1 inch/s of a wheel: 1 rad/s */
#define PERIOD   0.2            /* s */
#define BACK     1.0            /* s that it drives back */
#define HELD     2              /* periods that wheels stand until the load is too much */
#define MOST     1.3            /* pucks that it does not leave */
#define PI       3.14159265358979

/* Ranges of the camera, in 0.1 inch from the robot's centre. */
#define TOUCH    32             /* what it pushes is nearer */
#define BESIDE   50             /* what lies with that is nearer */
#define GROUP    75             /* before it touches one, whatever lies with others is nearer */
#define NEAR     65             /* walls and robots that it turns away from */
#define CLEAR    140            /* the same, when it pushes a puck */
#define DEPTH    12             /* how much farther the sides of a puck are than its front */

#define COLUMNS  60             /* of the camera */
#define COLUMN   0.0349         /* rad: from one to the next */
#define WIDTH    20             /* 0.1 inch: what is seen of a puck */
#define PUCK     0x008000       /* green */
#define NOTHING  0x000000       /* black */

static struct crs_pixel row[COLUMNS];

/* Returns how many pucks are within a range, by the width that is seen of them. */
static double pucks(int range)
{
    double width = 0;
    int i;

    for (i = 0; i < COLUMNS; i++)
        if (row[i].colour == PUCK && row[i].range < range)
            width += COLUMN * row[i].range;
    return width / WIDTH;
}

/* Returns whether the robot pushes a puck. */
static int pushes(void)
{
    return pucks(TOUCH) > 0.5;
}

/* Returns whether a wall or a robot is near. */
static int blocked(void)
{
    int near = pushes() ? CLEAR : NEAR, i;

    for (i = 0; i < COLUMNS; i++)
        if (row[i].colour != PUCK && row[i].colour != NOTHING && row[i].range < near)
            return 1;
    return 0;
}

/* Returns the direction of the nearest puck, in radians to the left; 0 if there is none. */
static double direction(void)
{
    int nearest = -1, count = 0, i;
    double sum = 0;

    for (i = 0; i < COLUMNS; i++)
        if (row[i].colour == PUCK && (nearest < 0 || row[i].range < row[nearest].range))
            nearest = i;
    for (i = 0; nearest >= 0 && i < COLUMNS; i++)
        if (row[i].colour == PUCK && row[i].range < row[nearest].range + DEPTH) {
            sum += (COLUMNS - 1) / 2.0 - i;
            count++;
        }
    return count ? COLUMN * sum / count : 0;
}

/* Drives for some time, and takes a picture. */
static void drive(double ahead, double turn, double seconds)
{
    vm((int)(ahead + turn), (int)(ahead - turn), 0);
    usleep((int)(seconds * 1e6));
    crs_camera(row, COLUMNS);
}

/* Turns on the spot to anywhere but ahead. */
static void turn_away(void)
{
    drive(0, SPIN, PI / 2 + PI * rand() / RAND_MAX);
}

/* Returns whether something holds the wheels. */
static int is_held(void)
{
    get_rv();
    return abs((int)State[STATE_VEL_RIGHT]) + abs((int)State[STATE_VEL_LEFT]) < SPEED / 2;
}

int main(void)
{
    int held = 0, seed = 0, i;

    if (!connect_robot(1) || crs_camera(row, COLUMNS) != COLUMNS)
        return 1;
    conf_tm(0);
    for (i = 0; i < COLUMNS; i++)
        seed = 31 * seed + row[i].range;
    srand(seed + crs_my_number());      /* noisy ranges: another one for each seed */
    for (;;) {
        if (blocked()) {
            turn_away();
        } else if (LEAVE && (held > HELD || pucks(pushes() ? BESIDE : GROUP) > MOST)) {
            drive(-SPEED, 0, BACK);
            turn_away();
        }
        drive(SPEED, TURN * direction(), PERIOD);
        held = is_held() ? held + 1 : 0;
    }
}
