/*
 * dead_reckoning.c - three position estimates compared with the truth.
 *
 *     speeds    what this program works out from the speeds of the wheels, read ten
 *               times a second: every reading stands for the whole tenth
 *     encoders  what the robot works out from the turns of its wheels
 *     truth     where the simulator has the robot: get_rpx(). No robot has that
 *
 * The robot drives a square to the left and one to the right (Borenstein and Feng 1994:
 * errors that one of them hides, the other shows), then hits a wall at an angle and
 * continues to push. Its motors stall, and its wheels slip along the wall, which the
 * encoders do not measure: from then on their position is wrong. Landmarks with known
 * positions could correct it.
 *
 * All positions are in the frame of the start.
 *
 * Usage:  crs run dead_reckoning.c wall.xml
 */

#include <math.h>
#include <stdio.h>
#include <sys/time.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define MAX_ROBOTS 20
#define SIDE       300                /* of the squares, 0.1 inch */
#define PERIOD     100000             /* microseconds */
#define BASE       (2.0 * ROTATION_CONSTANT * 180.0 / M_PI)   /* between the wheels, inches */

typedef struct { double x, y, theta; } Pose;      /* inches, radians */

static Pose speeds;                   /* our own estimate */
static Pose origin;                   /* the true pose at the start, in the world's frame */
static double last_time;
static double right_now, left_now;    /* previous reading, inches/s */

static double now(void)
{
    struct timeval t;

    gettimeofday(&t, NULL);
    return t.tv_sec % 86400 + t.tv_usec / 1e6;
}

/* Integrates the mean of two speed readings. */
static void integrate(void)
{
    double time, dt, right, left, way, turn;

    get_rv();
    time = now();
    dt = time - last_time;
    right = State[STATE_VEL_RIGHT] / 10.0;
    left = State[STATE_VEL_LEFT] / 10.0;
    way = ((right + right_now) + (left + left_now)) / 4.0 * dt;
    turn = ((right + right_now) - (left + left_now)) / 2.0 / BASE * dt;
    speeds.x += way * cos(speeds.theta + turn / 2.0);
    speeds.y += way * sin(speeds.theta + turn / 2.0);
    speeds.theta += turn;
    last_time = time;
    right_now = right;
    left_now = left;
}

static Pose encoders(void)
{
    Pose p;

    get_rc();
    p.x = State[STATE_CONF_X] / 10.0;
    p.y = State[STATE_CONF_Y] / 10.0;
    p.theta = State[STATE_CONF_STEER] * M_PI / 1800.0;
    return p;
}

/* Reads the true pose in the world's frame; FALSE if it is not available. */
static int world_pose(Pose *p)
{
    long robots[1 + 3 * MAX_ROBOTS];

    if (!get_rpx(robots) || robots[0] < 1)
        return FALSE;
    p->x = robots[1] / 10.0;
    p->y = robots[2] / 10.0;
    p->theta = robots[3] * M_PI / 1800.0;
    return TRUE;
}

static int truth(Pose *p)
{
    Pose w;

    if (!world_pose(&w))
        return FALSE;
    p->x = cos(origin.theta) * (w.x - origin.x) + sin(origin.theta) * (w.y - origin.y);
    p->y = cos(origin.theta) * (w.y - origin.y) - sin(origin.theta) * (w.x - origin.x);
    p->theta = w.theta - origin.theta;
    return TRUE;
}

static double degrees(double radians)
{
    return remainder(radians, 2.0 * M_PI) * 180.0 / M_PI;
}

static void print_opinion(const Pose *p, const Pose *true_pose)
{
    printf("  %6.1f %6.1f %6.1f", p->x, p->y, degrees(p->theta));
    if (true_pose != NULL)
        printf("  (%4.1f in %5.1f deg)", hypot(p->x - true_pose->x, p->y - true_pose->y),
               degrees(p->theta - true_pose->theta));
}

static void compare(const char *where)
{
    Pose e = encoders(), t;
    int known = truth(&t);

    printf("%-13s", where);
    print_opinion(&speeds, known ? &t : NULL);
    print_opinion(&e, known ? &t : NULL);
    if (known)
        print_opinion(&t, NULL);
    printf("\n");
}

/* Integrates until the wheels have stopped, or time is up. */
static void watch(double seconds)
{
    double until = now() + seconds;

    do {
        usleep(PERIOD - 25000);
        integrate();
    } while (now() < until && (right_now != 0.0 || left_now != 0.0));
}

static void go(int trans, int steer)
{
    scout_pr(trans, steer);
    usleep(50000);
    integrate();
    watch(30.0);
}

static void square(int turn, const char *name)
{
    int side;

    for (side = 0; side < 4; side++) {
        go(SIDE, 0);
        go(0, turn);
    }
    compare(name);
}

int main(void)
{
    int i;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "dead_reckoning: no robot\n");
        return 1;
    }
    conf_tm(10);
    ac(200, 200, 0);
    sp(100, 100, 0);
    dp(0, 0);
    da(0, 0);
    world_pose(&origin);
    last_time = now();

    printf("               speeds                (error)           encoders              (error) "
           "          truth\n");
    compare("start");
    square(900, "left square");
    square(-900, "right square");

    for (i = 0; i < 400 && State[STATE_BUMPER] == 0; i++) {
        scout_vm(80, 0);
        usleep(PERIOD / 2);
        integrate();
        get_bp();
    }
    compare("at the wall");
    for (i = 0; i < 40; i++) {
        scout_vm(80, 0);
        usleep(PERIOD / 2);
        integrate();
    }
    compare("pushed");
    st();
    watch(5.0);
    go(-200, 0);
    compare("away again");
    disconnect_robot(ROBOT_ID);
    return 0;
}
