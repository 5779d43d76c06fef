/*
 * figure_eight.c - two circles at a steady 10 Hz, by gettimeofday() and usleep().
 *
 * A control loop must know its timing errors. Each iteration starts at a multiple of
 * PERIOD after the start; the program sleeps for the rest of it. An iteration that took
 * longer is counted as missed, and the next one starts immediately.
 *
 * The robot drives a circle to the left and one to the right. Its target position at each
 * time is known; the deviation is fed back to the speeds, since wheel speeds are
 * multiples of 0.1 inch per second, and the circle would not close without that.
 *
 * The last lines show the regularity of the loop.
 *
 * Usage:  crs run figure_eight.c               needs 2 m to the left and to the right
 */

#include <stdio.h>
#include <math.h>
#include <sys/time.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID  1
#define PERIOD    100000L       /* microseconds */
#define RADIUS    30.0          /* of each circle, inches */
#define SPEED     8.0           /* inches/s */
#define AHEAD     1.0           /* gain along the way, 1/s */
#define ASIDE     0.05          /* gain across the way, rad/s per inch and inch/s */
#define TURN      1.5           /* gain on the heading, 1/s */

struct pose { double x, y, heading; };

struct loop {
    struct timeval start;
    long turns, missed;
    long least, most, last;     /* microseconds per iteration */
    double sum, squares;
};

static long microseconds_since(const struct timeval *start)
{
    struct timeval now;

    gettimeofday(&now, NULL);
    return (now.tv_sec - start->tv_sec) * 1000000L + now.tv_usec - start->tv_usec;
}

static void start_loop(struct loop *loop)
{
    static const struct loop fresh = { .least = 1000000000L };

    *loop = fresh;
    gettimeofday(&loop->start, NULL);
}

/* Sleeps until the next iteration; returns its time in seconds since the start. */
static double next_turn(struct loop *loop)
{
    long late = microseconds_since(&loop->start) - ++loop->turns * PERIOD;
    long now, period;

    if (late < 0)
        usleep(-late);
    else
        loop->missed++;
    now = microseconds_since(&loop->start);
    period = now - loop->last;
    loop->last = now;
    if (period < loop->least)
        loop->least = period;
    if (period > loop->most)
        loop->most = period;
    loop->sum += period;
    loop->squares += (double) period * period;
    return now / 1e6;
}

static void show_loop(const struct loop *loop)
{
    double mean = loop->sum / loop->turns;

    printf("%ld turns, %ld missed; period %.2f ms, deviation %.2f, from %.2f to %.2f\n",
           loop->turns, loop->missed, mean / 1000.0,
           sqrt(fmax(0.0, loop->squares / loop->turns - mean * mean)) / 1000.0,
           loop->least / 1000.0, loop->most / 1000.0);
}

/* Returns the target position at a time: on the left circle, then on the right. */
static struct pose wanted(double seconds)
{
    double angle = SPEED * seconds / RADIUS;
    double side = angle < 2.0 * M_PI ? 1.0 : -1.0;
    struct pose p;

    p.heading = side * fmod(angle, 2.0 * M_PI);
    p.x = RADIUS * sin(fabs(p.heading));
    p.y = side * RADIUS * (1.0 - cos(p.heading));
    return p;
}

static struct pose encoders(void)
{
    struct pose p;

    get_rc();
    p.x = State[STATE_CONF_X] / 10.0;
    p.y = State[STATE_CONF_Y] / 10.0;
    p.heading = State[STATE_CONF_STEER] * M_PI / 1800.0;
    return p;
}

/* Returns the distance of the robot from where it should be, after it has set the wheels. */
static double steer(struct pose is, struct pose ought, double side)
{
    double dx = ought.x - is.x, dy = ought.y - is.y;
    double ahead = cos(is.heading) * dx + sin(is.heading) * dy;
    double aside = cos(is.heading) * dy - sin(is.heading) * dx;
    double turn = remainder(ought.heading - is.heading, 2.0 * M_PI);
    double speed = SPEED * cos(turn) + AHEAD * ahead;
    double rate = side * SPEED / RADIUS + ASIDE * SPEED * aside + TURN * turn;

    scout_vm((int) (10.0 * speed + 0.5), (int) floor(10.0 * rate * 180.0 / M_PI + 0.5));
    return hypot(dx, dy);
}

int main(void)
{
    const double once = 2.0 * M_PI * RADIUS / SPEED;   /* seconds for a circle */
    struct loop loop;
    struct pose is;
    double seconds = 0.0, off, worst = 0.0;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "figure_eight: no robot\n");
        return 1;
    }
    conf_tm(1);
    ac(200, 200, 0);
    dp(0, 0);
    da(0, 0);

    printf("     s       x      y  heading   off\n");
    start_loop(&loop);
    while (seconds < 2.0 * once) {
        is = encoders();
        off = steer(is, wanted(seconds), seconds < once ? 1.0 : -1.0);
        if (off > worst)
            worst = off;
        if (loop.turns % 30 == 0)
            printf("%6.1f  %6.1f %6.1f   %6.1f  %4.1f\n", seconds, is.x, is.y,
                   is.heading * 180.0 / M_PI, off);
        seconds = next_turn(&loop);
    }
    st();
    ws(1, 1, 0, 5);
    is = encoders();
    printf("back at (%.1f, %.1f) after %.1f s, never more than %.1f in off\n", is.x, is.y,
           seconds, worst);
    show_loop(&loop);
    disconnect_robot(ROBOT_ID);
    return 0;
}
