/* A beam against a shape, see `geometry/rays.py`. Points and directions are pairs x, y. Each function is
   called at one place of each file that includes this, where it is inlined. */
#ifndef CRS_BEAMS_H
#define CRS_BEAMS_H

#include <math.h>

#include "kernels.h"

#define SLACK 1e-9          /* [rad] rounding must not lose a beam */
#define WIDE 0.7            /* [rad] beams that are wider are all tried */
#define ON 1e-9             /* [m] a sensor on a side must not be outside of a piece, and inside for rays */
#define RADIAL 1e-9         /* beams whose lines pass the robot so near, for the distance, are seen as through it */
#define ROOT 1.4142136      /* more than the root of 2 */
#define BENT 1.0471977      /* more than asin(x) / x up to x = 0.5 */

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
static struct point lean;               /* that of beams that are not radial, see below */
static double wide;                     /* the angle of `margin` [rad] */
static double radial;                   /* the square of the distance from which beams are radial */

/* Beams that follow one another, of two turns, as one number. */
#define SPAN(first, end) ((long long)(first) << 32 | (end))
#define FIRST(span) ((int)((span) >> 32))
#define END(span) ((int)(span))
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
        struct point *facing = &robots[i].facing;

        __crs_sin_cos(facing->x, &facing->y, &facing->x);
    }
    for (i = 0; i < measured; i++)
        distances[i] = INFINITY;
    for (i = 0; wants_objects && i < count * beam_count; i++)
        objects[i] = -1;
}

/* The diamond angle of a direction, 0 to 4, which rises with the true one; `share` is y / (|x| + |y|). */
#define DIAMOND(x, y, share) ((x) < 0 ? 2 - (share) : (y) < 0 ? 4 + (share) : (share))

/* The number of a direction's bin. */
static int bin_of(double x, double y)
{
    double share = y / (__builtin_fabs(x) + __builtin_fabs(y));
    int bin = (int)(DIAMOND(x, y, share) * (RAY_BINS / 4));

    return bin < RAY_BINS ? bin : RAY_BINS - 1;
}

/* Set `lean` to the direction by which beams may be aside of what they hit, for a square of the distance from
   which it is no nearer; return 0 if all beams have to be tried. A point so far away on a line that passes the
   origin at `aside` is seen at an angle asin(aside / distance) from the line's direction, for which `margin`
   has room if beams are radial. */
static int leans(double square)
{
    double share = fan->aside / __builtin_sqrt(square), cosine;

    if (!(share < 0.5) || fan->widest > WIDE)
        return 0;
    cosine = __builtin_sqrt(1 - share * share);
    lean.x = cosine * margin.x - share * margin.y;
    lean.y = share * margin.x + cosine * margin.y;
    return 1;
}

/* Find the beams that may hit what lies between two directions, counter-clockwise from `begin`, and
   no nearer than a distance, whose square is given. */
static long long beams_between(const struct robot *robot, double begin_x, double begin_y,
                               double end_x, double end_y, double square)
{
    struct point lower, upper, off = margin;
    int low, high;

    if (!(square > radial)) {
        if (!leans(square))
            return beam_count;
        off = lean;
    }
    lower.x = begin_x;
    lower.y = begin_y;
    upper.x = end_x;
    upper.y = end_y;
    TURNED_BACK(lower, lower, robot->facing);
    TURNED_BACK(lower, lower, off);
    TURNED_BACK(upper, upper, robot->facing);
    TURNED(upper, upper, off);
    low = bin_of(lower.x, lower.y);
    high = bin_of(upper.x, upper.y);
    if (high < low)
        high += RAY_BINS;
    return SPAN((int)behind[low], (int)behind[high + 1]);
}

/* The same of a circle around a point: -1 if it is near, or beams are not radial. The diamond angle changes by
   no more than the true one, and the circle covers asin(radius / away) on each side, where |x| + |y| is at
   most ROOT * away. */
static long long beams_around(const struct robot *robot, double x, double y, double radius)
{
    double ahead = x * robot->facing.x + y * robot->facing.y;
    double aside = y * robot->facing.x - x * robot->facing.y;
    double sum = __builtin_fabs(ahead) + __builtin_fabs(aside), part = 1 / sum, half = radius * part, share;
    int low, high;

    if (!(half < 0.5 / ROOT && sum * sum > 8 * radial))     /* so it is at least half as far as its middle */
        return -1;
    share = DIAMOND(ahead, aside, aside * part);
    half = half * (ROOT * BENT) + wide;
    low = (int)((share - half + 4) * (RAY_BINS / 4));
    high = (int)((share + half + 4) * (RAY_BINS / 4));
    if (low >= RAY_BINS) {
        low -= RAY_BINS;
        high -= RAY_BINS;
    }
    if (high >= 2 * RAY_BINS)
        return -1;
    return SPAN((int)behind[low], (int)behind[high + 1]);
}

/* Cut off what is beyond a side of the beam. */
#define CUT(cosine)                                                     \
    do {                                                                \
        double a_ = (cosine) * ay - side_sin * ax;                      \
        double b_ = (cosine) * by - side_sin * bx;                      \
        double crossing_ = a_ / (a_ - b_);                              \
                                                                        \
        if (a_ > 0 && crossing_ > first)                                \
            first = crossing_;                                          \
        if (b_ > 0 && crossing_ < last)                                 \
            last = crossing_;                                           \
    } while (0)

/* The distance from a beam's start to the part of a segment inside the beam, whose axis is x. */
static double to_segment(double side_cos, double side_sin, double ax, double ay, double bx, double by)
{
    double first = 0, last = 1, share, x, y;

    CUT(side_cos);
    CUT(-side_cos);
    if (first > last)
        return INFINITY;
    x = bx - ax;
    y = by - ay;
    share = -(ax * x + ay * y) / (x * x + y * y);
    share = share < first ? first : share;
    share = share > last ? last : share;
    x = ax + share * x;
    y = ay + share * y;
    return __builtin_sqrt(x * x + y * y);
}

/* The same of a circle. */
static double to_circle(double side_cos, double side_sin, double x, double y, double radius)
{
    double along = side_cos * x + side_sin * y;
    double aside = side_cos * y - side_sin * x;
    double away, square = radius * radius - aside * aside;

    if (aside > radius * (1 + SLACK))
        return INFINITY;
    away = __builtin_sqrt(x * x + y * y);
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
    long long span;
    int i;
    const struct robot *robot = &robots[number];
    struct point a, b, along, foot, near_a, near_b;
    double dot, cross, share, square, length_square = segment->length * segment->length;

    a.x = segment->start.x - robot->place.x;
    a.y = segment->start.y - robot->place.y;
    b.x = segment->end.x - robot->place.x;
    b.y = segment->end.y - robot->place.y;
    cross = CROSS(a, b);
    if (cross > fan->start * segment->length)
        return;                 /* all beams start to its left, where its solid is */
    if (cross * cross > fan->reach * fan->reach * length_square * (1 + SLACK))
        return;                 /* its whole line is too far away */
    dot = DOT(a, b);
    share = (DOT(a, a) - dot) / length_square;
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    along.x = b.x - a.x;
    along.y = b.y - a.y;
    foot.x = a.x + share * along.x;
    foot.y = a.y + share * along.y;
    square = DOT(foot, foot);
    if (square > fan->reach * fan->reach)
        return;
    if (cross < 0)
        span = beams_between(robot, b.x, b.y, a.x, a.y, square);
    else
        span = beams_between(robot, a.x, a.y, b.x, b.y, square);
    for (i = FIRST(span); i < END(span); i++) {
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
        take(number, beam, to_segment(beam->side_cos, beam->side_sin, near_a.x, near_a.y, near_b.x, near_b.y),
             segment->object, wants_objects);
    }
}

/* The beams that may hit a circle that is so near that they may not be radial for it. */
static long long beams_about(const struct robot *robot, double x, double y, double radius)
{
    double away = __builtin_sqrt(x * x + y * y), gap = away > radius ? away - radius : 0;
    double square = (away - radius) * (away + radius);
    double along = __builtin_sqrt(square > 0 ? square : 0);     /* it covers twice asin(radius / away) */

    return beams_between(robot, x * along + y * radius, y * along - x * radius, x * along - y * radius,
                         y * along + x * radius, gap * gap);
}

static void try_circle(int number, const struct circle *circle, int wants_objects)
{
    long long span;
    int i;
    const struct robot *robot = &robots[number];
    double radius = circle->radius, square;
    struct point middle;

    if (circle->object == robot->own)
        return;
    middle.x = circle->middle.x - robot->place.x;
    middle.y = circle->middle.y - robot->place.y;
    square = DOT(middle, middle);
    if (square > (fan->reach + radius) * (fan->reach + radius) * (1 + SLACK))
        return;
    if (__builtin_sqrt(square) - radius > fan->reach)
        return;
    span = beams_around(robot, middle.x, middle.y, radius);
    if (span < 0)
        span = beams_about(robot, middle.x, middle.y, radius);
    for (i = FIRST(span); i < END(span); i++) {
        const struct beam *beam = &beams[i < beam_count ? i : i - beam_count];
        struct point start, axis, place;

        TURNED(start, robot->facing, beam->start);
        TURNED(axis, robot->facing, beam->axis);
        place.x = middle.x - start.x;
        place.y = middle.y - start.y;
        TURNED_BACK(place, place, axis);
        take(number, beam, to_circle(beam->side_cos, beam->side_sin, place.x, __builtin_fabs(place.y), radius),
             circle->object, wants_objects);
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
    wide = fan->widest + 4 * SLACK;
    margin.x = cos(wide);
    margin.y = sin(wide);
    radial = fan->widest > WIDE ? INFINITY : (fan->aside / RADIAL) * (fan->aside / RADIAL);
}

#endif
