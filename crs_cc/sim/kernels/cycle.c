/* The end of a cycle, to which all axes have been advanced, see `engine/environment.py`. */
#include <math.h>

#include "kernels.h"
#include "robot.h"

#define SAME 1e-9                       /* [m]: smaller differences are rounding errors */

/* Move robots as their wheels do; return how far they are off by rounding, at most, infinitely if a
   contact has held one up before. `before` gets where they were. */
static double glide(int count, double timestep, const struct robot *robot, struct body *body,
                    double *before)
{
    double most = 0;

    for (; count > 0; count--, robot++, body++, before += 2) {
        double x = robot->moved[0], y = robot->moved[1], off_x, off_y;

        before[0] = body->x;
        before[1] = body->y;
        body->x += x;
        body->y += y;
        body->velocity[0] = x / timestep;
        body->velocity[1] = y / timestep;
        off_x = __builtin_fabs(body->x - before[0] - x);
        off_y = __builtin_fabs(body->y - before[1] - y);
        most = off_x > most ? off_x : most;
        most = off_y > most ? off_y : most;
        if (robot->hindered)
            most = INFINITY;
    }
    return most;
}

static int work_is_done(int count, const struct robot *robot)
{
    for (; count > 0; count--, robot++)
        if (robot->slice[0] != 0 || robot->slice[1] != 0 || robot->slice[2] != 0
            || robot->slipping)
            return 1;
    return 0;
}

/* Drain a battery by the work of a cycle, see `devices/battery`; return whether there was any. */
static int drain(const struct robot *robot, const struct supply *supply, double timestep,
                 struct battery *battery)
{
    double work[AXES];
    int axis, works = robot->slipping;

    for (axis = 0; axis < AXES; axis++) {
        double way = robot->slice[axis] * supply->lever[axis];
        double speed = robot->axes.speed[axis] * supply->lever[axis];
        double faster = speed * speed - battery->speed[axis] * battery->speed[axis];

        faster = faster > 0 ? faster : 0;
        work[axis] = supply->friction * __builtin_fabs(way) + supply->mass * (faster / 2);
        battery->speed[axis] = speed;
        if (way != 0)
            works = 1;
    }
    battery->used += (work[0] + work[1] + work[2]) * supply->per_work;
    if (robot->slipping)
        battery->used += supply->stall * timestep;
    return works;
}

/* Add the way of a robot; set its directions to where its axes were turned. */
static void face(struct robot *robot, const struct constants *constants, const struct body *body,
                 const double *before)
{
    double x = body->x - before[0], y = body->y - before[1];

    robot->distance += __builtin_sqrt(x * x + y * y);
    robot->heading = __crs_in_turn(robot->facing);
    if (constants->is_synchro == 0)
        robot->base = robot->heading;
    robot->mount = constants->has_turret != 0 ? __crs_in_turn(robot->turret) : robot->base;
}

/* Return whether a robot's battery has become empty by its work. */
static int tire(const struct robot *robot, const struct constants *constants,
                const struct cycle *cycle, double joined, const struct tables *tables)
{
    struct battery *battery = &tables->batteries[(int)robot->battery];

    return drain(robot, &constants->supply, cycle->timestep, battery)
        && __crs_is_empty(robot, cycle->end - joined, tables);
}

int __crs_finish(int count, const struct cycle *cycle, const double *joined, double *before,
                 const struct tables *tables, int *empty)
{
    struct robot *robot = tables->robots;
    int i, axis, drains = cycle->drains < 0 ? work_is_done(count, robot) : (int)cycle->drains;

    empty[0] = empty[1] = 0;
    if (cycle->is_free && glide(count, cycle->timestep, robot, tables->bodies, before) > SAME)
        return NOT_HANDLED;
    for (i = 0; i < count; i++, robot++) {
        const struct constants *constants = &tables->kinds[(int)robot->kind];

        face(robot, constants, &tables->bodies[i], before + 2 * i);
        if (drains && robot->battery >= 0 && tire(robot, constants, cycle, joined[i], tables))
            empty[2 + empty[0]++] = i;
        if (__crs_is_empty(robot, cycle->end + cycle->timestep - joined[i], tables))
            empty[1] = 1;
        robot->moved[0] = robot->moved[1] = 0;
        for (axis = 0; axis < AXES; axis++)
            robot->slice[axis] = 0;
        robot->facing = robot->heading;
    }
    return ADVANCED;
}
