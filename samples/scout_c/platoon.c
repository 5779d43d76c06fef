/*
 * platoon.c - a convoy by radio: the leader broadcasts its position, the others follow.
 *
 * Every robot runs this program; number 0 leads. It drives a course, and broadcasts its
 * position. The others store these positions: the leader's trail. Robot n drives n gaps
 * behind the leader, along the trail instead of straight to the leader, so that it takes
 * every corner where the leader did. It steers to a point of the trail slightly ahead,
 * and its speed corrects its distance. Every message is complete, so a lost one costs
 * only one point of the trail.
 *
 * All robots use one frame: each sets its own odometry to its starting position. (convoy/
 * does it with sonars instead of messages.)
 *
 * Usage:  crs run platoon.c platoon.xml
 */

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "Nclient.h"
#include "crs.h"

#define GAP        315       /* from one robot to the next, 0.1 inch: 80 cm */
#define AHEAD      120       /* look-ahead distance, 0.1 inch */
#define CRUISE     80        /* 0.1 inch/s */
#define FASTEST    140
#define POINTS     2000
#define PERIOD     200000    /* of the leader's broadcasts, microseconds */
#define LOST       3000      /* time without messages after which to stop, ms */

enum type { POSITION, END };

struct point {
    int x, y;                /* 0.1 inch */
};

static struct point trail[POINTS];
static int n_trail;

static double distance(struct point a, struct point b)
{
    return hypot(a.x - b.x, a.y - b.y);
}

static struct point place(void)
{
    struct point here = { State[STATE_CONF_X], State[STATE_CONF_Y] };

    return here;
}

/* -- the leader ------------------------------------------------------------- */

static const struct leg {
    int trans, steer;        /* 0.1 inch/s, 0.1 degree/s */
    int seconds;
} course[] = {
    { CRUISE, 0, 16 }, { CRUISE, 60, 14 }, { CRUISE, 0, 6 }, { CRUISE, 60, 14 },
    { CRUISE, 0, 6 }, { CRUISE, 60, 6 }, { CRUISE, -60, 6 }, { CRUISE, 0, 6 },
};

static void lead(void)
{
    unsigned i;
    int n, sent = 0;

    for (i = 0; i < sizeof course / sizeof *course; i++)
        for (n = 0; n < course[i].seconds * 5; n++) {
            struct point here;

            scout_vm(course[i].trans, course[i].steer);
            get_rc();
            here = place();
            sent += crs_broadcast(POSITION, &here, sizeof here);
            usleep(PERIOD);
        }
    st();
    for (n = 0; n < 20; n++)             /* repeated because messages get lost */
        crs_broadcast(END, NULL, 0);
    printf("the leader told its place %d times\n", sent);
}

/* -- the others ------------------------------------------------------------- */

static void remember(struct point point)
{
    if (n_trail < POINTS && (n_trail == 0 || distance(point, trail[n_trail - 1]) > 5.0))
        trail[n_trail++] = point;
}

/* Returns the point of the trail at a distance from its end, or the first one. */
static struct point behind(double way)
{
    int i;

    for (i = n_trail - 1; i > 0; i--) {
        double step = distance(trail[i], trail[i - 1]);

        if (way <= step) {
            struct point point = trail[i];

            point.x += (int)((trail[i - 1].x - point.x) * way / step);
            point.y += (int)((trail[i - 1].y - point.y) * way / step);
            return point;
        }
        way -= step;
    }
    return trail[0];
}

/* Returns the distance from its end at which the trail is nearest to a point. */
static double way_behind(struct point here)
{
    double way = 0.0, best = 0.0, nearest = distance(here, trail[n_trail - 1]);
    int i;

    for (i = n_trail - 1; i > 0; i--) {
        struct point from = trail[i], to = trail[i - 1];
        double step = distance(from, to), x = (to.x - from.x) / step, y = (to.y - from.y) / step;
        double along = (here.x - from.x) * x + (here.y - from.y) * y, off;

        along = along < 0.0 ? 0.0 : along > step ? step : along;
        off = hypot(here.x - from.x - along * x, here.y - from.y - along * y);
        if (off < nearest) {
            nearest = off;
            best = way + along;
        }
        way += step;
    }
    return best;
}

static int clip(double value, int low, int high)
{
    return value < low ? low : value > high ? high : (int)value;
}

/* Drives to keep a distance behind the leader; returns the deviation. */
static double drive(double gap)
{
    struct point here = place(), goal;
    double way = way_behind(here), bearing, turn;

    goal = behind(way > AHEAD ? way - AHEAD : 0.0);
    bearing = atan2(goal.y - here.y, goal.x - here.x) * 1800.0 / M_PI;
    turn = fmod(bearing - State[STATE_CONF_STEER] + 5400.0, 3600.0) - 1800.0;
    scout_vm(clip((way - gap) * 0.6 + CRUISE, 0, FASTEST), clip(turn * 1.5, -450, 450));
    return way - gap;
}

static void follow(int number)
{
    struct crs_message message;
    double gap = number * GAP, worst = 0.0, error;
    int told = 0, silent = 0;

    while (silent < LOST) {
        if (crs_receive(&message, 100)) {
            struct point leader;

            if (message.type == END)
                break;
            memcpy(&leader, message.data, sizeof leader);
            remember(leader);
            told++;
            silent = 0;
        } else {
            silent += 100;
        }
        get_rc();
        if (n_trail == 0)
            continue;
        error = drive(gap);
        if (told > 25 && fabs(error) > fabs(worst))
            worst = error;
    }
    st();
    printf("robot %d heard of the leader %d times, and was %.1f in from its place at worst\n",
           number, told, worst / 10.0);
}

int main(void)
{
    int number = crs_my_number();

    if (!connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    ac(150, 150, 0);
    conf_tm(2);
    dp(-number * GAP, 0);
    da(0, 0);
    if (number == 0) {
        lead();
    } else {
        int i;

        for (i = number; i > 0; i--) {   /* the trail starts with the initial row */
            struct point point = { -i * GAP, 0 };

            remember(point);
        }
        follow(number);
    }
    disconnect_robot(1);
    return 0;
}
