/* The motion of axes, see `state/motion_profile.py`, `devices/drive` and `devices/odometry`: of whole
   robots, by rows; or parts of it, by columns that lie one after the other as Python lists them. */
#include <math.h>

#include "kernels.h"
#include "robot.h"

#define TURN (2 * M_PI)

struct profiles {
    double *start, *first, *ramp, *ramp_time, *cruise, *cruise_time, *brake_time, *begun, *total,
        *travelled, *to, *way, *speed;
};

struct columns {
    double *shaft, *told, *x, *y, *heading, *turret;
};

/* Take the columns of profiles; return what follows them. */
static double *take_profiles(struct profiles *p, int count, double *column)
{
    double **each = &p->start;
    int i;

    for (i = 0; i < 10; i++, column += AXES * count)
        each[i] = column;
    p->to = column;
    return column + count;
}

static double *take_columns(struct columns *o, int count, double *column)
{
    o->shaft = column;
    o->told = o->shaft + AXES * count;
    o->x = o->told + AXES * count;
    o->y = o->x + count;
    o->heading = o->y + count;
    o->turret = o->heading + count;
    return o->turret + count;
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

/* Advance one axis to a time. */
static void advance(const struct profiles *p, int i, double to)
{
    double since = to - p->start[i], travelled, speed;

    if (since >= p->ramp_time[i] + p->cruise_time[i] + p->brake_time[i]) {
        travelled = p->total[i];
        speed = 0;
    } else {
        double ramping = least(since, p->ramp_time[i]), behind = since - p->ramp_time[i];
        double cruising, braking, slowing;

        behind = behind > 0 ? behind : 0;
        cruising = least(behind, p->cruise_time[i]);
        braking = least(behind - cruising, p->brake_time[i]);
        slowing = p->brake_time[i] > 0 ? p->cruise[i] / p->brake_time[i] : 0;
        travelled = p->begun[i] + (p->first[i] + p->ramp[i] * ramping / 2) * ramping;
        travelled += p->cruise[i] * (cruising + braking) - slowing * braking * braking / 2;
        speed = since < p->ramp_time[i] ? p->first[i] + p->ramp[i] * ramping : p->cruise[i];
        speed -= slowing * braking;
    }
    p->way[i] = travelled - p->travelled[i];
    p->travelled[i] = travelled;
    p->speed[i] = speed;
}

static double weighted(const double *way, const double *weight)
{
    return way[0] * weight[0] + way[1] * weight[1] + way[2] * weight[2];
}

double __crs_in_turn(double angle)
{
    if (!(angle >= 0 && angle < TURN)) {
        angle = fmod(angle, TURN);
        if (angle < 0)
            angle += TURN;
    }
    return angle + 0.0;         /* never -0 */
}

/* Add a robot's motion to its odometry, in whole counts of the encoders. */
static void count_turns(const struct drive *drive, const struct columns *o, int i,
                        const double *way)
{
    double whole[AXES], turn, x, y;
    int axis, place = AXES * i;

    for (axis = 0; axis < AXES; axis++, place++) {
        double shaft = o->shaft[place] + way[axis];
        double told = rint(shaft / drive->count[axis]) * drive->count[axis];

        whole[axis] = told - o->told[place];
        o->shaft[place] = shaft;
        o->told[place] = told;
    }
    turn = weighted(whole, drive->turn);
    __crs_arc(o->heading[i], weighted(whole, drive->forward), turn, &x, &y);
    o->x[i] += x;
    o->y[i] += y;
    o->heading[i] = __crs_in_turn(o->heading[i] + turn);
    if (drive->turret != 0)
        o->turret[i] = __crs_in_turn(o->turret[i] + whole[2]);
}

/* Columns: the profiles, the time of each robot. Adds the ways and the speeds of the axes. */
void __crs_profiles(int count, double *columns)
{
    struct profiles p;
    int i;

    p.way = take_profiles(&p, count, columns);
    p.speed = p.way + AXES * count;
    for (i = 0; i < AXES * count; i++)
        advance(&p, i, p.to[i / AXES]);
}

/* Columns: the constants, the odometry, the way of each axis. */
void __crs_counts(int count, double *columns)
{
    const struct drive *drives = (const struct drive *)columns;
    struct columns o;
    double *way = take_columns(&o, count, (double *)(drives + count));
    int i;

    for (i = 0; i < count; i++)
        count_turns(&drives[i], &o, i, way + AXES * i);
}

/* Return the profiles of one robot. */
static struct profiles profiles_of(struct axes *axes, double *way)
{
    struct profiles p = { axes->start, axes->first, axes->ramp, axes->ramp_time, axes->cruise,
        axes->cruise_time, axes->brake_time, axes->begun, axes->total, axes->travelled, 0, way,
        axes->speed };

    return p;
}

static struct columns columns_of(struct odometry *o)
{
    struct columns found = { o->shaft, o->told, &o->x, &o->y, &o->heading, &o->turret };

    return found;
}

void __crs_lag(const struct constants *constants, double lag, const double *driven,
               double *counted)
{
    counted[0] = driven[0] - lag;
    counted[1] = constants->is_synchro != 0 ? driven[1] : driven[1] - lag;
    counted[2] = driven[2];
}

/* Count what the encoders of a robot tell of the ways of its axes in some time. */
static void count(struct robot *robot, const struct constants *constants, double time,
                  const double *way)
{
    struct columns o = columns_of(&robot->odometry);
    double turned[] = { way[0], way[1], way[2] };
    int axis;

    if (robot->hindered) {
        double ahead = weighted(way, constants->drive.forward) - robot->forward * time;

        robot->ahead += ahead;
        __crs_lag(constants, ahead, way, turned);
    }
    if (turned[0] == 0 && turned[1] == 0 && turned[2] == 0)
        return;
    for (axis = 0; axis < AXES; axis++)
        robot->slice[axis] += turned[axis];
    count_turns(&constants->drive, &o, 0, turned);
}

/* Advance a robot to a time. */
void __crs_move(struct robot *robot, const struct constants *constants, double to)
{
    const struct drive *drive = &constants->drive;
    double way[AXES], turn, x, y, time = to - robot->clock;
    struct profiles p = profiles_of(&robot->axes, way);
    int axis;

    robot->clock = to;
    for (axis = 0; axis < AXES; axis++)
        advance(&p, axis, to);
    count(robot, constants, time, way);
    if (way[0] == 0 && way[1] == 0 && way[2] == 0)
        return;
    turn = weighted(way, drive->true_turn);
    __crs_arc(robot->facing, weighted(way, drive->true_forward), turn, &x, &y);
    robot->moved[0] += x;
    robot->moved[1] += y;
    robot->facing += turn;
    robot->turret += way[2];
}

/* Return whether something is to happen to a robot before a time, or at it. */
static int is_due(const struct robot *robot, double time)
{
    if (robot->timer <= time || robot->fires <= time)
        return 1;
    return robot->listening != -1 && robot->hears <= time;
}

/* Advance robots to the time of each. If anything happens to one of them before, none is advanced:
   then return what. What sensors do counts up to the time `last`. Command timeouts begin anew if
   `renews` is set. */
int __crs_advance(int count, int renews, const long long *rows, double last, const double *to,
                  const struct tables *tables)
{
    int i;

    for (i = 0; i < count; i++) {
        const struct robot *robot = &tables->robots[rows ? rows[i] : i];

        if (is_due(robot, least(to[i], last)))
            return SENSOR_DUE;
        if (robot->deadline < to[i])
            return TIMEOUT_DUE;
    }
    for (i = 0; i < count; i++) {
        struct robot *robot = &tables->robots[rows ? rows[i] : i];

        __crs_move(robot, &tables->kinds[(int)robot->kind], to[i]);
        if (renews)
            robot->deadline = to[i] + robot->timeout;
    }
    return ADVANCED;
}

/* Ramp an axis to a speed and keep it. */
static void set_speed(struct axes *a, int axis, double now, double target, double ramp)
{
    double first = a->speed[axis], more = target - first, time = __builtin_fabs(more) / ramp;

    a->start[axis] = now;
    a->first[axis] = first;
    a->ramp[axis] = (more > 0 ? 1 : more < 0 ? -1 : 0) * ramp;
    a->ramp_time[axis] = time;
    a->cruise[axis] = target;
    a->cruise_time[axis] = target == 0 ? 0 : INFINITY;
    a->brake_time[axis] = a->begun[axis] = a->travelled[axis] = 0;
    a->limit[axis] = a->rate[axis] = 0;
    a->total[axis] = target == 0 ? first * time / 2 : NAN;
}

/* Ramp axes to speeds within their limits, from the time to which they have been advanced, with their
   own acceleration or others. `which` are the axes to change, 0 for all. */
void __crs_speeds(int count, const long long *rows, const double *speeds, const double *ramps,
                  const double *which, const struct tables *tables)
{
    int i, axis;

    for (i = 0; i < count; i++) {
        struct robot *robot = &tables->robots[rows ? rows[i] : i];
        const double *limit = tables->kinds[(int)robot->kind].speed_limit;
        const double *ramp = ramps ? ramps + AXES * i : robot->ramp;

        for (axis = 0; axis < AXES; axis++) {
            double speed = speeds[AXES * i + axis];

            if (which && which[AXES * i + axis] == 0)
                continue;
            speed = speed < -limit[axis] ? -limit[axis] : speed;
            speed = speed > limit[axis] ? limit[axis] : speed;
            set_speed(&robot->axes, axis, robot->clock, speed, ramp[axis]);
        }
    }
}
