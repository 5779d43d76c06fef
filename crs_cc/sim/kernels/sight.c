/* How many objects lie between the ends of lines, among shapes that lie in the arena sorted by the cells of a
   grid, see `sight_field.py`. A line is cut into pieces; each cell lists all shapes that a piece whose middle
   is in it can meet. Many lines from one place are swept first, see sweep.c. */
#include <math.h>

#include "sight.h"

struct piece_of_line {
    struct point start, along;
};

/* Whether a segment is on one side of a line, and not too near to that for any of its pieces. */
static int is_aside(const struct segment *segment, const struct line *line, double x, double y, double length)
{
    double low = x * (segment->start.y - line->start.y) - y * (segment->start.x - line->start.x);
    double high = x * (segment->end.y - line->start.y) - y * (segment->end.x - line->start.x);
    double away = length * NEAR;

    return (low * high > 0) & (__builtin_fabs(low) > away) & (__builtin_fabs(high) > away);
}

/* Whether the ends of each are on both sides of the other. */
static int crosses(const struct segment *segment, const struct piece_of_line *piece)
{
    double low_x = segment->start.x - piece->start.x, low_y = segment->start.y - piece->start.y;
    double high_x = segment->end.x - piece->start.x, high_y = segment->end.y - piece->start.y;
    double along_x = piece->along.x, along_y = piece->along.y, side_x, side_y;

    if ((along_x * low_y > along_y * low_x) == (along_x * high_y > along_y * high_x))
        return 0;
    side_x = segment->end.x - segment->start.x;
    side_y = segment->end.y - segment->start.y;
    return (side_x * low_y < side_y * low_x) != (side_x * (low_y - along_y) < side_y * (low_x - along_x));
}

/* Whether the middle of a circle is nearer to a piece than its radius, as `core/segment.py` has it. */
static int enters(const struct circle *circle, const struct piece_of_line *piece)
{
    double x = circle->middle.x - piece->start.x, y = circle->middle.y - piece->start.y;
    double along_x = piece->along.x, along_y = piece->along.y;
    double square = along_x * along_x + along_y * along_y;
    double share = (x * along_x + y * along_y) / (square > 0 ? square : 1);

    share = share > 0 ? share : 0;
    share = share < 1 ? share : 1;
    x -= share * along_x;
    y -= share * along_y;
    return __builtin_sqrt(x * x + y * y) < circle->radius;
}

/* Whether a line begins and ends in cells of the grid, so that all of it does. */
static int stays_within(double from, double to, int count)
{
    return from >= 0 && to >= 0 && from < count - SLACK && to < count - SLACK;
}

static int clamped(double place, int count)
{
    return place < 0 ? 0 : place < count ? (int)place : count - 1;
}

/* Return how many objects a line meets, but no more than `enough`; `view.met` has the last line of each. */
static int count_objects(const struct field *field, const struct line *line, int number, int enough)
{
    const int *first = view.first, *lists = view.lists;
    double x = line->end.x - line->start.x, y = line->end.y - line->start.y;
    double length = __builtin_sqrt(x * x + y * y), count = __builtin_ceil(length / PIECE);
    double share, u, v, du, dv;
    int columns = view.columns, rows = view.rows, met = 0, n, pieces, is_inside;
    struct piece_of_line piece;

    count = count > 1 ? count : 1;
    share = 1 / count;
    pieces = (int)count;
    piece.along.x = x * share;
    piece.along.y = y * share;
    /* The middle of the first piece, in cells, and those that follow. */
    du = piece.along.x * view.per_cell;
    dv = piece.along.y * view.per_cell;
    u = (line->start.x - field->x) * view.per_cell + du / 2;
    v = (line->start.y - field->y) * view.per_cell + dv / 2;
    is_inside = stays_within(u, u + (pieces - 1) * du, columns) && stays_within(v, v + (pieces - 1) * dv, rows);
    for (n = 0; n < pieces; n++) {
        double across = u + n * du, up = v + n * dv;
        int cell = is_inside ? (int)up * columns + (int)across
                             : clamped(up, rows) * columns + clamped(across, columns);
        int k = first[cell], last = first[cell + 1];

        if (k == last)
            continue;
        piece.start.x = line->start.x + n * piece.along.x;
        piece.start.y = line->start.y + n * piece.along.y;
        for (; k < last; k++) {
            int shape = lists[k], *object;

            if (shape < view.circle) {
                const struct segment *segment = &view.segments[shape];

                if (is_aside(segment, line, x, y, length))
                    continue;
                object = &view.met[(int)segment->object];
                if (*object == number || !crosses(segment, &piece))
                    continue;
            } else {
                const struct circle *circle = &view.circles[shape - view.circle];

                object = &view.met[(int)circle->object];
                if (*object == number || !enters(circle, &piece))
                    continue;
            }
            *object = number;
            if (++met >= enough)
                return met;
        }
    }
    return met;
}

/* Return how many lines follow each other from the same place, and how many pieces they have. */
static int run_of(int count, const struct line *lines, double *pieces)
{
    int i;

    *pieces = 0;
    for (i = 0; i < count; i++) {
        double x = lines[i].end.x - lines->start.x, y = lines[i].end.y - lines->start.y;

        if (lines[i].start.x != lines->start.x || lines[i].start.y != lines->start.y)
            break;
        *pieces += __builtin_sqrt(x * x + y * y) / PIECE + 1;
    }
    return i;
}

void __crs_sight(int count, const double *told, const double *content, int *counts)
{
    const struct field *field = (const struct field *)content;
    const struct line *lines = (const struct line *)told;
    int first, run, i;
    double pieces;

    open_field(field);
    for (i = 0; i < view.shapes; i++)
        view.met[i] = -1;
    for (first = 0; first < count; first += run) {
        run = run_of(count - first, lines + first, &pieces);
        if (pieces > view.shapes && view.shapes <= SWEPT)
            __crs_sweep(run, lines + first, content, counts + first, (double *)told + 5 * count);
        else
            for (i = first; i < first + run; i++)
                counts[i] = -counts[i];
        for (i = first; i < first + run; i++)
            if (counts[i] < 0)
                counts[i] = count_objects(field, &lines[i], i, -counts[i]);
    }
}
