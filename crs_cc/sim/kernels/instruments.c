/* Instruments that measure for replies: infrared rings and compasses, at most at their rates, if nothing
   is degraded and no surface is darker than others. The laws are those of `devices/infrared` and
   `devices/compass`. */
#include <math.h>

#include "calm.h"
#include "instruments.h"

#define ROUNDING 1e-9                   /* [s], as in `core/time_grid.py` */
#define FARTHEST 15                     /* the largest reading of a ring */
#define TENTH_DEGREE (M_PI / 1800)      /* [rad] */
#define FULL_TURN 3600
#define IR_0 1                          /* places in `State` */
#define COMPASS 43

static struct ring *ring_of(const struct calm *calm, long long robot)
{
    long long number = TABLE(calm, const long long, ring_of)[robot];

    return number < 0 ? 0 : TABLE(calm, struct ring, rings) + number;
}

static struct compass *compass_of(const struct calm *calm, long long robot)
{
    long long number = TABLE(calm, const long long, compass_of)[robot];

    return number < 0 ? 0 : TABLE(calm, struct compass, compasses) + number;
}

/* Return the errors of the next measurement of the ring or compass, 0 if it is not known. */
static const double *ring_errors(const struct calm *calm, const struct ring *ring)
{
    long long number = ring - TABLE(calm, const struct ring, rings);

    return __crs_drawn(calm, &calm->ring, number, ring->common.count, RAYS);
}

static const double *compass_errors(const struct calm *calm, const struct compass *compass)
{
    long long number = compass - TABLE(calm, const struct compass, compasses);

    return __crs_drawn(calm, &calm->compass, number, compass->common.count, 1);
}

int __crs_are_known(const struct calm *calm, long long robot)
{
    const struct ring *ring = ring_of(calm, robot);
    const struct compass *compass = compass_of(calm, robot);

    if (ring && calm->ring.draws && !ring_errors(calm, ring))
        return 0;
    return !(compass && calm->compass.draws) || compass_errors(calm, compass);
}

static int may_measure(const struct instrument *common, int kinds, int own, double at)
{
    int wanted = kinds & own || (kinds & MASKED && common->masked != 0);

    return wanted && common->on_request != 0
        && (common->at < 0 || at - common->at >= common->interval - ROUNDING);
}

/* Record that an instrument has measured. */
static void note(struct instrument *common, double at, const struct robot *robot,
                 const struct constants *constants)
{
    common->at = at;
    common->count++;
    __crs_report(robot, constants, common->configuration);
}

/* Return what a sensor reads before rounding, without a memory, at a distance. */
static double level_at(double distance, double step)
{
    double level = step > 0 ? distance / step : distance > 0 ? INFINITY : 0;

    level = level > 0 ? level : 0;
    return level < FARTHEST ? level : FARTHEST;
}

/* Measure with a ring whose mount is at a place, and points into a direction. */
static void sweep(const struct calm *calm, struct ring *ring, double *viewer)
{
    static double distances[2 * RAYS];
    const double *errors = calm->ring.draws ? ring_errors(calm, ring) : 0;
    int i;

    __crs_scan(1, (int)calm->segment_count, (int)calm->circle_count, (int)calm->piece_count,
               TABLE(calm, const double, fans) + (long long)ring->fan, viewer, distances,
               TABLE(calm, const double, segments));
    for (i = 0; i < RAYS; i++) {
        double distance = distances[i], level;

        if (errors)
            distance += errors[i] * ring->common.noise;
        level = level_at(distance, ring->step);
        level = ring->share * ring->level[i] + (1 - ring->share) * level;
        ring->level[i] = ring->on[i] != 0 ? level : FARTHEST;
    }
}

/* Measure with a compass whose mount points into a direction. */
static void take_bearing(const struct calm *calm, struct compass *compass, double direction)
{
    double angle = direction + (compass->offset + compass->deviation * sin(direction));
    int tenths;

    if (calm->compass.draws)
        angle += compass_errors(calm, compass)[0] * compass->common.noise;
    tenths = (int)rint(angle / TENTH_DEGREE) % FULL_TURN;
    compass->reading = tenths < 0 ? tenths + FULL_TURN : tenths;
}

void __crs_measure(struct calm *calm, long long number, int kinds, double at,
                   const struct tables *tables)
{
    const struct robot *robot = &tables->robots[number];
    const struct constants *constants = &tables->kinds[(int)robot->kind];
    const struct body *body = &tables->bodies[number];
    struct ring *ring = ring_of(calm, number);
    struct compass *compass = compass_of(calm, number);
    double direction = __crs_mount(robot, constants);

    if (ring && may_measure(&ring->common, kinds, RINGS, at)) {
        double viewer[] = { body->x + robot->moved[0], body->y + robot->moved[1], direction, 0,
            (double)number };

        sweep(calm, ring, viewer);
        note(&ring->common, at, robot, constants);
    }
    if (compass && compass->on != 0 && may_measure(&compass->common, kinds, COMPASSES, at)) {
        take_bearing(calm, compass, direction);
        note(&compass->common, at, robot, constants);
    }
}

void __crs_tell(const struct calm *calm, long long robot, int *state)
{
    const struct ring *ring = ring_of(calm, robot);
    const struct compass *compass = compass_of(calm, robot);
    int i;

    for (i = 0; ring && i < RAYS; i++)
        state[IR_0 + i] = (int)rint(ring->level[i]);
    if (compass)
        state[COMPASS] = (int)compass->reading;
}
