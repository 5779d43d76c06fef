/* How many objects many lines meet that begin at one place: the directions in which each shape is seen from there
   select lines. Where rounding could matter, a line is left to sight.c: at the ends of lines, of their pieces
   and of segments, at the sides of circles, and along segments. So the results are the same. */
#include <math.h>

#include "sight.h"

#define BINS 2048                       /* of directions in a turn */
#define RAYS 1024                       /* lines that are swept at once */
#define SLIGHT 1e-6                     /* a difference of directions that is more than rounding errors */
#define THIN 1e-3                       /* a segment is so wide across a line, or along it [m] */
#define WHOLE_TURN 4                    /* of diamond angles */

struct ray {
    double x, y, length, piece;
    int last, left, number;             /* object met last; how many more are enough; number of the line */
    int is_hard;
};

static struct ray *rays;
static int *begin;                      /* the first ray of each bin */
static int *bins;                       /* that of each line */
static int spans[2][2];                 /* rays that may meet a shape: two ranges */

static double direction_of(double x, double y)
{
    double share = y / (__builtin_fabs(x) + __builtin_fabs(y));

    return DIAMOND(x, y, share);
}

/* Sort lines by direction. */
static void take_lines(int count, const struct line *lines, const int *counts)
{
    int i, bin;

    for (bin = 0; bin <= BINS; bin++)
        begin[bin] = 0;
    for (i = 0; i < count; i++) {
        double x = lines[i].end.x - lines[i].start.x, y = lines[i].end.y - lines[i].start.y;

        bin = x == 0 && y == 0 ? 0 : (int)(direction_of(x, y) * (BINS / WHOLE_TURN));
        bins[i] = bin = bin < BINS ? bin : BINS - 1;
        begin[bin + 1]++;
    }
    for (bin = 0; bin < BINS; bin++)
        begin[bin + 1] += begin[bin];
    for (i = count - 1; i >= 0; i--) {
        double x = lines[i].end.x - lines[i].start.x, y = lines[i].end.y - lines[i].start.y, pieces;
        struct ray *ray = &rays[--begin[bins[i] + 1]];

        ray->x = x;
        ray->y = y;
        ray->length = __builtin_sqrt(x * x + y * y);
        pieces = __builtin_ceil(ray->length / PIECE);
        ray->piece = ray->length / (pieces > 1 ? pieces : 1);
        ray->last = -1;
        ray->left = counts[i];
        ray->number = i;
        ray->is_hard = !(ray->length > NEAR);
    }
    /* Each is where the bin before it begins now. */
    for (bin = 0; bin < BINS; bin++)
        begin[bin] = begin[bin + 1];
    begin[BINS] = count;
}

static void select_all(void)
{
    spans[0][0] = 0;
    spans[0][1] = begin[BINS];
    spans[1][0] = spans[1][1] = 0;
}

/* Select the rays between two directions, counter-clockwise. */
static void select_between(double from_x, double from_y, double to_x, double to_y)
{
    double from = direction_of(from_x, from_y) - SLIGHT, to = direction_of(to_x, to_y) + SLIGHT;
    int low, high;

    if (from < 0) {
        from += WHOLE_TURN;
        to += WHOLE_TURN;
    }
    if (to < from)
        to += WHOLE_TURN;
    low = (int)(from * (BINS / WHOLE_TURN));
    high = (int)(to * (BINS / WHOLE_TURN));
    low = low < BINS ? low : BINS - 1;
    spans[0][0] = begin[low];
    spans[1][0] = 0;
    if (high < BINS) {
        spans[0][1] = begin[high + 1];
        spans[1][1] = 0;
    } else {
        high -= BINS;
        spans[0][1] = begin[BINS];
        spans[1][1] = begin[high < low ? high + 1 : low];
    }
}

/* Try a segment, from `a` to `b` as seen from where the rays begin, with those that are selected. */
static void try_rays_with_segment(double ax, double ay, double bx, double by, int object)
{
    double cross = ax * by - ay * bx;
    int span, k;

    for (span = 0; span < 2; span++)
        for (k = spans[span][0]; k < spans[span][1]; k++) {
            struct ray *ray = &rays[k];
            double low = ray->x * ay - ray->y * ax, high = ray->x * by - ray->y * bx;
            double near = NEAR * ray->length, way, end;

            if ((ray->last == object) | (ray->left <= 0)
                | ((low * high > 0) & (__builtin_fabs(low) > near) & (__builtin_fabs(high) > near)))
                continue;
            if ((__builtin_fabs(low) <= near) | (__builtin_fabs(high) <= near)
                | (__builtin_fabs(high - low) < THIN * ray->length)) {
                ray->is_hard = 1;
                continue;
            }
            way = cross / (high - low) * ray->length;
            if ((way < -NEAR) | (way > ray->length + NEAR))
                continue;
            end = __builtin_floor(way / ray->piece + 0.5) * ray->piece;
            if (__builtin_fabs(way - end) < NEAR) {
                ray->is_hard = 1;
                continue;
            }
            ray->last = object;
            ray->left--;
        }
}

/* A line that begins outside of an object enters it through a side whose front it sees. */
static void sweep_segment(const struct segment *segment, const struct point *start, int object, int is_outside)
{
    double ax = segment->start.x - start->x, ay = segment->start.y - start->y;
    double bx = segment->end.x - start->x, by = segment->end.y - start->y;
    double cross = ax * by - ay * bx, dot = ax * bx + ay * by;
    double a_square = ax * ax + ay * ay, b_square = bx * bx + by * by;

    if (is_outside && cross > NEAR * (__builtin_fabs(bx - ax) + __builtin_fabs(by - ay)))
        return;
    if (!(a_square > THIN * THIN && b_square > THIN * THIN)
        || (dot < 0 && cross * cross < THIN * a_square * b_square))
        select_all();
    else if (cross > 0)
        select_between(ax, ay, bx, by);
    else
        select_between(bx, by, ax, ay);
    try_rays_with_segment(ax, ay, bx, by, object);
}

static void sweep_circle(const struct circle *circle, const struct point *start, int object)
{
    double x = circle->middle.x - start->x, y = circle->middle.y - start->y, radius = circle->radius;
    double square = x * x + y * y, side = radius + THIN;
    int span, k;

    if (square > 2 * side * side) {
        double ahead = __builtin_sqrt(square - side * side);

        select_between(x * ahead + y * side, y * ahead - x * side, x * ahead - y * side, y * ahead + x * side);
    } else {
        select_all();
    }
    for (span = 0; span < 2; span++)
        for (k = spans[span][0]; k < spans[span][1]; k++) {
            struct ray *ray = &rays[k];
            double share, away_x, away_y, gap;

            if ((ray->last == object) | (ray->left <= 0) | ray->is_hard)
                continue;
            share = (x * ray->x + y * ray->y) / (ray->length * ray->length);
            share = share > 0 ? share : 0;
            share = share < 1 ? share : 1;
            away_x = x - share * ray->x;
            away_y = y - share * ray->y;
            gap = __builtin_sqrt(away_x * away_x + away_y * away_y) - radius;
            if (__builtin_fabs(gap) < NEAR) {
                ray->is_hard = 1;
            } else if (gap < 0) {
                ray->last = object;
                ray->left--;
            }
        }
}

/* List the shapes of the field that is open by object. */
static void list_by_object(int *order, int *firsts)
{
    int i;

    for (i = 0; i <= view.shapes; i++)
        firsts[i] = 0;
    for (i = 0; i < view.circle; i++)
        firsts[(int)view.segments[i].object]++;
    for (i = view.circle; i < view.shapes; i++)
        firsts[(int)view.circles[i - view.circle].object]++;
    for (i = 1; i <= view.shapes; i++)
        firsts[i] += firsts[i - 1];
    for (i = 0; i < view.circle; i++)
        order[--firsts[(int)view.segments[i].object]] = i;
    for (i = view.circle; i < view.shapes; i++)
        order[--firsts[(int)view.circles[i - view.circle].object]] = i;
}

/* Find the boxes around the objects of the field that is open. */
static void find_boxes(struct box *boxes)
{
    int i;

    for (i = 0; i < view.shapes; i++) {
        boxes[i].left = boxes[i].low = INFINITY;
        boxes[i].right = boxes[i].high = -INFINITY;
    }
    for (i = 0; i < view.circle; i++) {
        const struct segment *segment = &view.segments[i];

        stretch(&boxes[(int)segment->object], segment->start.x, segment->start.y, THIN);
        stretch(&boxes[(int)segment->object], segment->end.x, segment->end.y, THIN);
    }
    for (i = 0; i < view.shapes - view.circle; i++) {
        const struct circle *circle = &view.circles[i];

        stretch(&boxes[(int)circle->object], circle->middle.x, circle->middle.y, circle->radius + THIN);
    }
}

static int is_outside(const struct box *box, const struct point *point)
{
    return point->x < box->left || point->x > box->right || point->y < box->low || point->y > box->high;
}

void __crs_sweep(int count, const struct line *lines, const double *content, int *counts, double *work)
{
    struct box *boxes;
    int first, i, k, *order;

    open_field((const struct field *)content);
    rays = (struct ray *)work;
    boxes = (struct box *)(rays + RAYS);
    begin = (int *)(boxes + view.shapes);
    bins = begin + BINS + 1;
    order = bins + RAYS;
    list_by_object(order, order + view.shapes);
    find_boxes(boxes);
    for (first = 0; first < count; first += RAYS) {
        int some = count - first < RAYS ? count - first : RAYS;

        take_lines(some, lines + first, counts + first);
        for (k = 0; k < view.shapes; k++) {
            int shape = order[k];

            if (shape < view.circle) {
                const struct segment *segment = &view.segments[shape];

                int object = (int)segment->object;

                sweep_segment(segment, &lines->start, object, is_outside(&boxes[object], &lines->start));
            } else {
                const struct circle *circle = &view.circles[shape - view.circle];

                sweep_circle(circle, &lines->start, (int)circle->object);
            }
        }
        for (i = 0; i < some; i++) {
            int *found = &counts[first + rays[i].number];

            *found = rays[i].is_hard ? -*found : *found - rays[i].left;
        }
    }
}
