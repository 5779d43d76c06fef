/* Beams among many shapes, which lie in the arena sorted by the cells of a grid, see `beam_field.py`. Each
   cell lists all shapes whose bounding boxes it meets; those beyond the grid are in cells at its edge. */
#include "beams.h"

/* What lies in the arena for shapes that stay, and again for those that move: then rows of segments,
   circles and pieces; then integers: where the list of each cell begins, the last robot that has met each
   shape, and the lists. */
struct field {
    double segments, circles, pieces;   /* how many */
    double x, y, cell;                  /* corner of the grid, and size of its cells [m] */
    double columns, rows;
};

struct box {
    double left, right, low, high;
};

struct view {
    const struct segment *segments;
    const struct circle *circles;
    const struct piece *pieces;
    int *first, *met, *lists;
    int columns, rows, cells, circle, piece, shapes;    /* numbers of the first circle and piece */
};

static struct view view;

static void open_field(const struct field *field)
{
    view.circle = (int)field->segments;
    view.piece = view.circle + (int)field->circles;
    view.shapes = view.piece + (int)field->pieces;
    view.columns = (int)field->columns;
    view.rows = (int)field->rows;
    view.cells = view.columns * view.rows;
    view.segments = (const struct segment *)(field + 1);
    view.circles = (const struct circle *)(view.segments + view.circle);
    view.pieces = (const struct piece *)(view.circles + (view.piece - view.circle));
    view.first = (int *)(view.pieces + (view.shapes - view.piece));
    view.met = view.first + view.cells + 1;
    view.lists = view.met + view.shapes;
}

static void stretch(struct box *box, double x, double y, double by)
{
    box->left = x - by < box->left ? x - by : box->left;
    box->right = x + by > box->right ? x + by : box->right;
    box->low = y - by < box->low ? y - by : box->low;
    box->high = y + by > box->high ? y + by : box->high;
}

static void bound(int shape, struct box *box)
{
    box->left = box->low = INFINITY;
    box->right = box->high = -INFINITY;
    if (shape < view.circle) {
        const struct segment *segment = &view.segments[shape];

        stretch(box, segment->start.x, segment->start.y, 0);
        stretch(box, segment->end.x, segment->end.y, 0);
    } else if (shape < view.piece) {
        const struct circle *circle = &view.circles[shape - view.circle];

        stretch(box, circle->middle.x, circle->middle.y, circle->radius);
    } else {
        const struct piece *piece = &view.pieces[shape - view.piece];

        stretch(box, piece->middle.x, piece->middle.y, piece->half_length + piece->half_width);
    }
}

static int place_of(double at, double corner, double cell, int count)
{
    double place = (at - corner) / cell;

    return place < 0 ? 0 : place < count ? (int)place : count - 1;
}

/* The first and last column and row of the cells that meet a box. */
static void meet(const struct field *field, const struct box *box, int *range)
{
    range[0] = place_of(box->left, field->x, field->cell, view.columns);
    range[1] = place_of(box->right, field->x, field->cell, view.columns);
    range[2] = place_of(box->low, field->y, field->cell, view.rows);
    range[3] = place_of(box->high, field->y, field->cell, view.rows);
}

int __crs_sort(double *content, int room)
{
    const struct field *field = (const struct field *)content;
    struct box box;
    int range[4], pass, shape, cell, row, column, total = 0;

    open_field(field);
    for (cell = 0; cell <= view.cells; cell++)
        view.first[cell] = 0;
    for (pass = 0; pass < 2; pass++) {
        for (shape = view.shapes - 1; shape >= 0; shape--) {
            bound(shape, &box);
            meet(field, &box, range);
            for (row = range[2]; row <= range[3]; row++)
                for (column = range[0]; column <= range[1]; column++) {
                    cell = row * view.columns + column;
                    if (pass == 0)
                        view.first[cell]++;
                    else
                        view.lists[--view.first[cell]] = shape;
                }
        }
        if (pass > 0)
            break;
        for (cell = 0; cell < view.cells; cell++)
            view.first[cell] = total += view.first[cell];
        view.first[view.cells] = total;
        if ((double *)(view.lists + total + 1) > content + room)
            return 0;
    }
    return (int)((double *)(view.lists + total + 1) - content) + 1;
}

/* Try all shapes of a field with a robot. */
static void look(const struct field *field, int number)
{
    const struct robot *robot = &robots[number];
    struct box box;
    int range[4], row, k, last;

    open_field(field);
    box.left = box.right = robot->place.x;
    box.low = box.high = robot->place.y;
    stretch(&box, robot->place.x, robot->place.y, fan->reach * (1 + SLACK));
    meet(field, &box, range);
    for (row = range[2]; row <= range[3]; row++) {
        k = view.first[row * view.columns + range[0]];
        last = view.first[row * view.columns + range[1] + 1];
        for (; k < last; k++) {
            int shape = view.lists[k];

            if (view.met[shape] == number)
                continue;
            view.met[shape] = number;
            if (shape < view.circle)
                try_segment(number, &view.segments[shape], 0);
            else if (shape < view.piece)
                try_circle(number, &view.circles[shape - view.circle], 0);
            else
                try_piece(number, &view.pieces[shape - view.piece]);
        }
    }
}

void __crs_survey(int count, const double *fan_table, double *robot_table, double *out,
                  const double *fixed, const double *moving)
{
    const struct field *fields[2];
    int i, k;

    fields[0] = (const struct field *)fixed;
    fields[1] = (const struct field *)moving;
    take_fan(fan_table, robot_table);
    distances = out;
    objects = out + count * beam_count;
    prepare(count, count * beam_count, 1);
    for (k = 0; k < 2; k++) {
        open_field(fields[k]);
        for (i = 0; i < view.shapes; i++)
            view.met[i] = -1;
        for (i = 0; i < count; i++)
            look(fields[k], i);
    }
    for (i = 0; i < count * beam_count; i++)
        if (objects[i] >= 0)
            distances[i] = 0;
}
