/* How much room discs have among shapes that lie in the arena sorted by the cells of a grid, see
   `room_field.py`. */
#include <math.h>

#include "grid.h"

/* What is asked, and the discs, which come behind it. */
struct question {
    double look, need;                  /* how far to look; less room than is needed [m] */
    double thickest;                    /* the largest radius around a segment [m] */
};

struct disc {
    double x, y, radius, own;           /* the number of the circle that it is, -1 if it is none */
};

/* The distance of a place from a segment, as `core/segment.py` has it. */
static double from_segment(const struct segment *segment, double x, double y)
{
    double along_x = segment->end.x - segment->start.x, along_y = segment->end.y - segment->start.y;
    double square = along_x * along_x + along_y * along_y, share;

    x -= segment->start.x;
    y -= segment->start.y;
    share = (x * along_x + y * along_y) / (square > 0 ? square : 1);
    share = share > 0 ? share : 0;
    share = share < 1 ? share : 1;
    x -= share * along_x;
    y -= share * along_y;
    return __builtin_sqrt(x * x + y * y);
}

static double from_circle(const struct circle *circle, double x, double y)
{
    x -= circle->middle.x;
    y -= circle->middle.y;
    return __builtin_sqrt(x * x + y * y);
}

/* Return how much room a disc has, at most `room`, and mark the segments that are too near. The `length` of a
   segment is the radius around it here. */
static double measure(const struct field *field, const struct question *question,
                      const struct disc *disc, double room, int *near)
{
    double reach = question->look + disc->radius + question->thickest + ON, gap;
    struct box box;
    int range[4], row, k, last;

    box.left = box.right = disc->x;
    box.low = box.high = disc->y;
    stretch(&box, disc->x, disc->y, reach);
    meet(field, &box, range);
    for (row = range[2]; row <= range[3]; row++) {
        last = view.first[row * view.columns + range[1] + 1];
        for (k = view.first[row * view.columns + range[0]]; k < last; k++) {
            int shape = view.lists[k];

            if (shape < view.circle) {
                const struct segment *segment = &view.segments[shape];

                gap = from_segment(segment, disc->x, disc->y);
                gap -= segment->length + disc->radius;
                if (gap < question->need)
                    near[shape] = 1;
            } else {
                const struct circle *circle = &view.circles[shape - view.circle];

                if (circle->object == disc->own)
                    continue;
                gap = from_circle(circle, disc->x, disc->y);
                gap = gap - circle->radius - disc->radius;
            }
            room = gap < room ? gap : room;
        }
    }
    return room;
}

void __crs_room(int count, const double *asked, const double *content, double *rooms, int *near)
{
    const struct question *question = (const struct question *)asked;
    const struct disc *discs = (const struct disc *)(question + 1);
    const struct field *field = (const struct field *)content;
    int i;

    open_field(field);
    for (i = 0; i < view.circle; i++)
        near[i] = 0;
    for (i = 0; i < count; i++)
        rooms[i] = measure(field, question, &discs[i], rooms[i], near);
}
