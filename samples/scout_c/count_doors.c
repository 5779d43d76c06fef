/*
 * count_doors.c - drive along a corridor and count the doors on both sides.
 *
 * The sonars at 90 degrees measure the walls. Readings of the wall are averaged to get
 * its distance; where the reading grows by more than JUMP, an opening begins, and ends
 * where it returns. A sonar detects the nearest object within its whole beam, so an
 * opening appears narrower than it is, by the width of the beam at the distance of the
 * wall, which is added again.
 *
 * An opening of MIN_DOOR to MAX_DOOR inches is a door, a wider one a passage, a narrower
 * one a gap. The position along the corridor comes from the encoders.
 *
 * Usage:  crs run count_doors.c corridor.xml
 */

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID  1
#define SPEED     60       /* 0.1 inch/s: 6 inches a second */
#define END       22       /* the end wall is this near: stop, inches */
#define JUMP      16       /* depth of an opening behind the wall, inches */
#define RIPPLE    6        /* maximum deviation of the wall, inches */
#define MIN_DOOR  26       /* inches */
#define MAX_DOOR  48       /* inches */
#define BEAM      0.3527   /* 2 tan(10 degrees): width of the beam per inch of distance */
#define SHELL     8.0      /* radius of the robot: the sonars sit on its shell, inches */

enum { LEFT_SIDE, RIGHT_SIDE, SIDES };
enum kind { GAP, DOOR, PASSAGE, KINDS };

static const char *kind_name[KINDS] = { "gap", "door", "passage" };

struct opening {
    int side;
    double from, to;               /* along the corridor, inches */
    struct opening *next;
};

struct watch {
    const char *name;
    int sonar;                     /* index of its sonar in State */
    double wall;                   /* distance of the wall, inches; 0: unknown */
    double lost_at;                /* where the wall ended, inches */
    int is_open;
};

static struct watch watches[SIDES] = {
    { "left", STATE_SONAR_4 },
    { "right", STATE_SONAR_12 },
};

static struct opening *openings, **end_of_list = &openings;

/* Fires only the sonars needed, each 5 times per second. */
static int order[16] = { 4, 12, 0, 255 };

static enum kind kind_of(const struct opening *o)
{
    double width = o->to - o->from;

    return width < MIN_DOOR ? GAP : width <= MAX_DOOR ? DOOR : PASSAGE;
}

static const struct opening *remember(int side, double from, double to)
{
    struct opening *o = malloc(sizeof *o);

    if (o == NULL) {
        fprintf(stderr, "count_doors: no memory\n");
        exit(1);
    }
    o->side = side;
    o->from = from;
    o->to = to;
    o->next = NULL;
    *end_of_list = o;
    end_of_list = &o->next;
    return o;
}

/* Evaluates one side at a position along the corridor. */
static void look(int side, double along)
{
    struct watch *w = &watches[side];
    double reading = State[w->sonar];

    if (w->wall == 0.0) {
        w->wall = reading;
    } else if (!w->is_open && reading > w->wall + JUMP) {
        w->is_open = 1;
        w->lost_at = along;
    } else if (w->is_open && reading < w->wall + JUMP / 2) {
        double edge = BEAM / 2.0 * (w->wall + SHELL);
        const struct opening *o = remember(side, w->lost_at - edge, along + edge);

        w->is_open = 0;
        printf("%-5s  %5.1f to %5.1f in   %s\n", w->name, o->from, o->to,
               kind_name[kind_of(o)]);
    } else if (!w->is_open && abs((int) (reading - w->wall)) < RIPPLE) {
        w->wall += 0.01 * (reading - w->wall);
    }
}

/* Degrees from the direction of the corridor, -180 to 180. */
static double heading(void)
{
    double degrees = State[STATE_CONF_STEER] / 10.0;

    return degrees > 180.0 ? degrees - 360.0 : degrees;
}

/* Keeps to the centre while there are walls on both sides, otherwise straight on. */
static int steering(void)
{
    double aside = 0.0;            /* offset to the right of the centre, inches */
    double left = State[STATE_SONAR_4], right = State[STATE_SONAR_12];
    double steer;

    if (left < watches[LEFT_SIDE].wall + 4 && right < watches[RIGHT_SIDE].wall + 4)
        aside = (left - right) / 2.0;
    steer = 8.0 * aside - 30.0 * heading();
    return steer > 150.0 ? 150 : steer < -150.0 ? -150 : (int) steer;
}

static void summary(void)
{
    int count[SIDES][KINDS] = { { 0 } };
    struct opening *o;

    while ((o = openings) != NULL) {
        count[o->side][kind_of(o)]++;
        openings = o->next;
        free(o);
    }
    printf("doors: %d left, %d right; passages: %d left, %d right\n",
           count[LEFT_SIDE][DOOR], count[RIGHT_SIDE][DOOR],
           count[LEFT_SIDE][PASSAGE], count[RIGHT_SIDE][PASSAGE]);
}

int main(void)
{
    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "count_doors: no robot\n");
        return 1;
    }
    conf_tm(2);
    conf_sn(15, order);
    ac(100, 100, 0);
    dp(0, 0);
    da(0, 0);
    usleep(300000);                        /* until each sonar has fired */
    gs();

    while (State[STATE_SONAR_0] > END && State[STATE_BUMPER] == 0) {
        look(LEFT_SIDE, State[STATE_CONF_X] / 10.0);
        look(RIGHT_SIDE, State[STATE_CONF_X] / 10.0);
        scout_vm(SPEED, steering());
        usleep(30000);
        gs();
    }
    st();
    ws(1, 1, 0, 5);
    get_rc();
    printf("end of the corridor after %.1f in\n", State[STATE_CONF_X] / 10.0);
    summary();
    disconnect_robot(ROBOT_ID);
    return 0;
}
