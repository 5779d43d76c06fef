/* A beam against a shape, see `geometry/rays.py`. Points and directions are pairs x, y. Each function is
   called at one place of each file that includes this, where it is inlined. */
#ifndef CRS_BEAMS_H
#define CRS_BEAMS_H

#include <math.h>

#include "kernels.h"

#define SLACK 1e-9          /* [rad] rounding must not lose a beam */
#define WIDE 0.7            /* [rad] beams that are wider are all tried */
#define ON 1e-9             /* [m] a sensor on a side must not be outside of a piece, and inside for rays */

struct point {
    double x, y;
};

/* Rows of the tables that `rays.py` makes. */
struct fan {
    double beams, reach, start, aside, widest, unused;
};

struct beam {
    struct point start, axis;           /* relative to the robot */
    double side_cos, side_sin, range, order;
};

struct robot {
    struct point place, facing;         /* facing.x is the heading until `prepare` */
    double own;                         /* the number of its own body */
};

/* The robot of a shape is -1 if all may see it. */

struct segment {
    double robot, object;
    struct point start, end;
    double length;
};

struct circle {
    double robot, object;
    struct point middle;
    double radius;
};

/* A rectangle, or a triangle in one, see `geometry/contact_mask.py`. */
struct piece {
    double robot, object;
    struct point middle, along;
    double half_length, half_width;
    struct point slants[2];
    double slant_distances[2];
};

static const struct fan *fan;
static const struct beam *beams;
static const double *behind;            /* number of beams before each direction, for two turns */
static struct robot *robots;
static double *distances, *objects;     /* of the beams of all robots; no objects if not wanted */
static int beam_count;
static struct point margin;             /* the direction at the angle of the widest beam's side */

#define CROSS(a, b) ((a).x * (b).y - (a).y * (b).x)
#define DOT(a, b) ((a).x * (b).x + (a).y * (b).y)
#define TURNED(result, a, b)                            \
    do {                                                \
        double x_ = (a).x * (b).x - (a).y * (b).y;      \
        (result).y = (a).x * (b).y + (a).y * (b).x;     \
        (result).x = x_;                                \
    } while (0)
#define TURNED_BACK(result, a, b)                       \
    do {                                                \
        double x_ = (a).x * (b).x + (a).y * (b).y;      \
        (result).y = (a).y * (b).x - (a).x * (b).y;     \
        (result).x = x_;                                \
    } while (0)

static void prepare(int count, int measured, int wants_objects)
{
    int i;

    for (i = 0; i < count; i++) {
        double heading = robots[i].facing.x;

        robots[i].facing.x = cos(heading);
        robots[i].facing.y = sin(heading);
    }
    for (i = 0; i < measured; i++)
        distances[i] = INFINITY;
    for (i = 0; wants_objects && i < count * beam_count; i++)
        objects[i] = -1;
}

/* The number of a direction's bin: of the diamond angle, which rises with the true one. */
static int bin_of(const struct point *direction)
{
    double x = direction->x, y = direction->y, sum = __builtin_fabs(x) + __builtin_fabs(y);
    double share = y / sum, angle = x < 0 ? 2 - share : y < 0 ? 4 + share : share;
    int bin = (int)(angle * (RAY_BINS / 4));

    return bin < RAY_BINS ? bin : RAY_BINS - 1;
}

/* Find the beams that may hit what lies between two directions, counter-clockwise from `begin`, and
   no nearer than a distance. A point so far away on a line that passes the origin at `aside` is seen
   at an angle asin(aside / distance) from the line's direction. */
static void beams_between(const struct robot *robot, const struct point *begin,
                          const struct point *end, double distance, int *first, int *count)
{
    struct point lower, upper, off;
    double share = fan->aside / distance, cosine;
    int low, high;

    if (!(share < 0.5) || fan->widest > WIDE) {
        *first = 0;
        *count = beam_count;
        return;
    }
    cosine = __builtin_sqrt(1 - share * share);
    off.x = cosine * margin.x - share * margin.y;
    off.y = share * margin.x + cosine * margin.y;
    TURNED_BACK(lower, *begin, robot->facing);
    TURNED_BACK(lower, lower, off);
    TURNED_BACK(upper, *end, robot->facing);
    TURNED(upper, upper, off);
    low = bin_of(&lower);
    high = bin_of(&upper);
    if (high < low)
        high += RAY_BINS;
    *first = (int)behind[low];
    *count = (int)behind[high + 1] - *first;
}

/* The distance from a beam's start to the part of a segment inside the beam, whose axis is x. */
static double to_segment(const struct beam *beam, const struct point *a, const struct point *b)
{
    double first = 0, last = 1, cosine = beam->side_cos, share, x, y;
    struct point along;
    int side;

    for (side = 0; side < 2; side++, cosine = -cosine) {
        double outside_a = cosine * a->y - beam->side_sin * a->x;
        double outside_b = cosine * b->y - beam->side_sin * b->x;
        double crossing = outside_a / (outside_a - outside_b);

        if (outside_a > 0 && crossing > first)
            first = crossing;
        if (outside_b > 0 && crossing < last)
            last = crossing;
    }
    if (first > last)
        return INFINITY;
    along.x = b->x - a->x;
    along.y = b->y - a->y;
    share = -DOT(*a, along) / DOT(along, along);
    share = share < first ? first : share;
    share = share > last ? last : share;
    x = a->x + share * along.x;
    y = a->y + share * along.y;
    return __builtin_sqrt(x * x + y * y);
}

/* The same of a circle. */
static double to_circle(const struct beam *beam, const struct point *middle, double radius)
{
    double x = middle->x, y = __builtin_fabs(middle->y);
    double along = beam->side_cos * x + beam->side_sin * y;
    double aside = beam->side_cos * y - beam->side_sin * x;
    double away = __builtin_sqrt(x * x + y * y), square = radius * radius - aside * aside;

    if (away <= radius)
        return 0;
    if (aside <= 0)
        return away - radius;
    if (square < 0 || along < 0)
        return INFINITY;
    return along - __builtin_sqrt(square);
}

/* A later one of hits at the same distance counts. */
static void take(int robot, const struct beam *beam, double distance, double object,
                 int wants_objects)
{
    int place = robot * beam_count + (int)beam->order;

    if (distance <= distances[place] && distance <= beam->range) {
        distances[place] = distance;
        if (wants_objects)
            objects[place] = object;
    }
}

static void try_segment(int number, const struct segment *segment, int wants_objects)
{
    int first, count, i;
    const struct robot *robot = &robots[number];
    struct point a, b, along, foot, near_a, near_b;
    double dot, cross, share, square;

    a.x = segment->start.x - robot->place.x;
    a.y = segment->start.y - robot->place.y;
    b.x = segment->end.x - robot->place.x;
    b.y = segment->end.y - robot->place.y;
    cross = CROSS(a, b);
    if (cross > fan->start * segment->length)
        return;                 /* all beams start to its left, where its solid is */
    dot = DOT(a, b);
    share = (DOT(a, a) - dot) / (segment->length * segment->length);
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    along.x = b.x - a.x;
    along.y = b.y - a.y;
    foot.x = a.x + share * along.x;
    foot.y = a.y + share * along.y;
    square = DOT(foot, foot);
    if (square > fan->reach * fan->reach)
        return;
    if (cross < 0)
        beams_between(robot, &b, &a, __builtin_sqrt(square), &first, &count);
    else
        beams_between(robot, &a, &b, __builtin_sqrt(square), &first, &count);
    for (i = first; i < first + count; i++) {
        const struct beam *beam = &beams[i < beam_count ? i : i - beam_count];
        struct point start, axis;

        TURNED(start, robot->facing, beam->start);
        TURNED(axis, robot->facing, beam->axis);
        near_a.x = a.x - start.x;
        near_a.y = a.y - start.y;
        near_b.x = b.x - start.x;
        near_b.y = b.y - start.y;
        TURNED_BACK(near_a, near_a, axis);
        TURNED_BACK(near_b, near_b, axis);
        take(number, beam, to_segment(beam, &near_a, &near_b), segment->object, wants_objects);
    }
}

static void try_circle(int number, const struct circle *circle, int wants_objects)
{
    int first, count, i;
    const struct robot *robot = &robots[number];
    double radius = circle->radius, away, square;
    struct point middle, begin, end, half;

    if (circle->object == robot->own)
        return;
    middle.x = circle->middle.x - robot->place.x;
    middle.y = circle->middle.y - robot->place.y;
    square = DOT(middle, middle);
    if (square > (fan->reach + radius) * (fan->reach + radius) * (1 + SLACK))
        return;
    away = __builtin_sqrt(square);
    if (away - radius > fan->reach)
        return;
    square = (away - radius) * (away + radius);
    half.x = __builtin_sqrt(square > 0 ? square : 0);   /* it covers twice asin(radius / away) */
    half.y = radius;
    TURNED_BACK(begin, middle, half);
    TURNED(end, middle, half);
    beams_between(robot, &begin, &end, away > radius ? away - radius : 0, &first, &count);
    for (i = first; i < first + count; i++) {
        const struct beam *beam = &beams[i < beam_count ? i : i - beam_count];
        struct point start, axis, place;

        TURNED(start, robot->facing, beam->start);
        TURNED(axis, robot->facing, beam->axis);
        place.x = middle.x - start.x;
        place.y = middle.y - start.y;
        TURNED_BACK(place, place, axis);
        take(number, beam, to_circle(beam, &place, radius), circle->object, wants_objects);
    }
}

static int is_within(const struct piece *piece, const struct point *place, double margin)
{
    return __builtin_fabs(place->x) <= piece->half_length + margin
        && __builtin_fabs(place->y) <= piece->half_width + margin;
}

static int is_left_of_slants(const struct piece *piece, const struct point *place)
{
    return DOT(piece->slants[0], *place) <= piece->slant_distances[0] + ON
        && DOT(piece->slants[1], *place) <= piece->slant_distances[1] + ON;
}

/* Find the beams that start on a piece or in it. The last piece of several counts. */
static void try_piece(int number, const struct piece *piece)
{
    const struct robot *robot = &robots[number];
    struct point local, facing, start;
    int i;

    /* In the frame of the piece: its centre is the origin, x is its long axis. */
    local.x = robot->place.x - piece->middle.x;
    local.y = robot->place.y - piece->middle.y;
    TURNED_BACK(local, local, piece->along);
    if (!is_within(piece, &local, fan->start + 2 * ON))
        return;
    TURNED_BACK(facing, robot->facing, piece->along);
    for (i = 0; i < beam_count; i++) {
        TURNED(start, facing, beams[i].start);
        start.x += local.x;
        start.y += local.y;
        if (is_within(piece, &start, ON) && is_left_of_slants(piece, &start))
            objects[number * beam_count + (int)beams[i].order] = piece->object;
    }
}

static void take_fan(const double *table, double *robot_table)
{
    fan = (const struct fan *)table;
    beam_count = (int)fan->beams;
    beams = (const struct beam *)(fan + 1);
    behind = (const double *)(beams + beam_count);
    robots = (struct robot *)robot_table;
    margin.x = cos(fan->widest + 2 * SLACK);
    margin.y = sin(fan->widest + 2 * SLACK);
}

#endif
