/* The motion of axes, see `state/motion_profile.py`, `devices/drive` and `devices/odometry`. The
   columns of all robots lie one after the other in the order in which Python lists them. */
#include <math.h>

#include "kernels.h"

#define AXES 3
#define TURN (2 * M_PI)

/* A row of the table of constants, see `devices/drive/constants.py`. */
struct drive {
    double turn[AXES], forward[AXES], true_turn[AXES], true_forward[AXES], count[AXES], turret;
};

struct profiles {
    double *start, *first, *ramp, *ramp_time, *cruise, *cruise_time, *brake_time, *begun, *total,
        *travelled, *to, *way, *speed;
};

struct odometry {
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

static double *take_odometry(struct odometry *o, int count, double *column)
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

/* Python's remainder. */
static double in_turn(double angle)
{
    if (!(angle >= 0 && angle < TURN)) {
        angle = fmod(angle, TURN);
        if (angle < 0)
            angle += TURN;
    }
    return angle + 0.0;         /* never -0 */
}

/* Add a robot's motion to its odometry, in whole counts of the encoders. */
static void count_turns(const struct drive *drive, const struct odometry *o, int i,
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
    o->heading[i] = in_turn(o->heading[i] + turn);
    if (drive->turret != 0)
        o->turret[i] = in_turn(o->turret[i] + whole[2]);
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
    struct odometry o;
    double *way = take_odometry(&o, count, (double *)(drives + count));
    int i;

    for (i = 0; i < count; i++)
        count_turns(&drives[i], &o, i, way + AXES * i);
}

/* Columns: the profiles, the time of each robot, its constants, its odometry, the distances of its
   axes in this cycle, its displacement, the directions of wheels and turret. Adds ways and speeds. */
void __crs_moves(int count, double *columns)
{
    struct profiles p;
    struct odometry o;
    const struct drive *drives = (const struct drive *)take_profiles(&p, count, columns);
    double *slice = take_odometry(&o, count, (double *)(drives + count));
    double *moved = slice + AXES * count, *facing = moved + 2 * count, *turret = facing + count;
    int i, axis;

    p.way = turret + count;
    p.speed = p.way + AXES * count;
    for (i = 0; i < count; i++) {
        const struct drive *drive = &drives[i];
        double *way = p.way + AXES * i, turn, x, y;

        for (axis = 0; axis < AXES; axis++)
            advance(&p, AXES * i + axis, p.to[i]);
        if (way[0] == 0 && way[1] == 0 && way[2] == 0)
            continue;
        for (axis = 0; axis < AXES; axis++)
            slice[AXES * i + axis] += way[axis];
        count_turns(drive, &o, i, way);
        turn = weighted(way, drive->true_turn);
        __crs_arc(facing[i], weighted(way, drive->true_forward), turn, &x, &y);
        moved[2 * i] += x;
        moved[2 * i + 1] += y;
        facing[i] += turn;
        turret[i] += way[2];
    }
}
