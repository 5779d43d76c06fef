/* The end of a cycle in calm time, see calm.c: robots move as their wheels do, if nothing is near. */
#include <math.h>

#include "calm.h"
#include "robot.h"

static double at_least(double a, double b)
{
    return a > b ? a : b;
}

static double at_most(double a, double b)
{
    return a < b ? a : b;
}

static double nearest_side(const struct calm *calm, double x, double y, double most)
{
    const double *segment = TABLE(calm, const double, segments);
    int i;

    for (i = 0; i < calm->segment_count; i++, segment += SEGMENT_SIZE) {
        double across_x = x - segment[2], across_y = y - segment[3];
        double along_x = segment[4] - segment[2], along_y = segment[5] - segment[3];
        double length2 = along_x * along_x + along_y * along_y;
        double share = (across_x * along_x + across_y * along_y) / (length2 > 0 ? length2 : 1);

        share = at_most(at_least(share, 0), 1);
        across_x -= share * along_x;
        across_y -= share * along_y;
        most = at_most(most, __builtin_sqrt(across_x * across_x + across_y * across_y));
    }
    return most;
}

static double nearest_circle(const struct calm *calm, double x, double y, int own, double most)
{
    const double *circle = TABLE(calm, const double, circles);
    int i;

    for (i = 0; i < calm->circle_count; i++, circle += CIRCLE_SIZE) {
        double off_x = x - circle[2], off_y = y - circle[3];

        if (i != own)
            most = at_most(most, __builtin_sqrt(off_x * off_x + off_y * off_y) - circle[4]);
    }
    return most;
}

static double nearest(const struct calm *calm, double x, double y, int own)
{
    return nearest_circle(calm, x, y, own, nearest_side(calm, x, y, INFINITY));
}

/* Return the shortest distance between a robot and anything else, see `geometry/clearance.py`. */
static double clearance(const struct calm *calm)
{
    const double *circle = TABLE(calm, const double, circles);
    double most = INFINITY;
    int i;

    for (i = 0; i < calm->circle_count; i++, circle += CIRCLE_SIZE) {
        double x = circle[2], y = circle[3];

        if (circle[1] < calm->count)
            most = at_most(most, nearest(calm, x, y, i) - circle[4]);
    }
    return most;
}

/* Return whether robots have room for this cycle, which is reserved, and change no goal in it. */
static int has_room(struct calm *calm, const struct tables *tables)
{
    double way = 0, need, room = calm->room;
    int i;

    for (i = 0; i < calm->count; i++) {
        const double *moved = tables->robots[i].moved;

        way = at_least(way, __builtin_fabs(moved[0]) + __builtin_fabs(moved[1]));
    }
    if (!(calm->goal_room >= 2 * way))
        return 0;
    need = 2 * way + calm->slop;
    if (room < need)
        room = clearance(calm);
    room -= need;
    if (!(room >= 0))
        return 0;
    calm->room = room;
    calm->goal_room -= 2 * way;
    return 1;
}

static void copy(double *to, const double *from, long long count)
{
    for (; count > 0; count--)
        *to++ = *from++;
}

/* Exchange what `finish` changes with its copy. */
static void keep(const struct calm *calm, const struct tables *tables, int restores)
{
    void *parts[] = { tables->robots, tables->bodies, tables->batteries };
    const long long sizes[] = { sizeof *tables->robots, sizeof *tables->bodies,
        sizeof *tables->batteries };
    double *kept = TABLE(calm, double, backup);
    int i;

    for (i = 0; i < 3; i++) {
        long long count = sizes[i] / 8 * calm->count;

        if (restores)
            copy(parts[i], kept, count);
        else
            copy(kept, parts[i], count);
        kept += count;
    }
}

/* Move bodies, as nothing is near; return whether that is all. */
static int finish(struct calm *calm, const struct tables *tables)
{
    static double before[2 * MOST];
    static int empty[2 + MOST];
    struct cycle cycle = { calm->timestep, calm->end, 1, -1 };
    const double *joined = TABLE(calm, const double, joined);

    if (!has_room(calm, tables)
        || __crs_finish((int)calm->count, &cycle, joined, before, tables, empty) != ADVANCED
        || empty[0] != 0)
        return 0;
    calm->is_weary = empty[1];
    return 1;
}

/* Log where robots are, and place their outlines there. */
static void show(const struct calm *calm, const struct tables *tables)
{
    struct frame *frame = TABLE(calm, struct frame, frames) + calm->ended * calm->count;
    double *circle = TABLE(calm, double, circles);
    int i;

    for (i = 0; i < calm->circle_count; i++, circle += CIRCLE_SIZE)
        if (circle[1] < calm->count) {
            circle[2] = tables->bodies[(int)circle[1]].x;
            circle[3] = tables->bodies[(int)circle[1]].y;
        }
    for (i = 0; i < (calm->frame_room ? calm->count : 0); i++, frame++) {
        const struct robot *robot = &tables->robots[i];
        const struct odometry *odometry = &robot->odometry;

        frame->x = tables->bodies[i].x;
        frame->y = tables->bodies[i].y;
        frame->heading = robot->heading;
        frame->turret = robot->turret;
        frame->believed[0] = odometry->x;
        frame->believed[1] = odometry->y;
        frame->believed[2] = odometry->heading;
    }
}

int __crs_calm_move(struct calm *calm, const struct tables *tables)
{
    double room = calm->room, goal_room = calm->goal_room;

    keep(calm, tables, 0);
    if (finish(calm, tables)) {
        show(calm, tables);
        return 1;
    }
    keep(calm, tables, 1);
    calm->room = room;
    calm->goal_room = goal_room;
    return 0;
}
