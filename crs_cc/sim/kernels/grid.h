/* Shapes that lie in the arena sorted by the cells of a grid, see survey.c. */
#ifndef CRS_GRID_H
#define CRS_GRID_H

#include "beams.h"

/* What lies in the arena for shapes that stay, and again for those that move: then rows of segments,
   circles and pieces; then integers: where the list of each cell begins, the last robot that has met each
   shape, and the lists. */
struct field {
    double segments, circles, pieces;   /* how many */
    double x, y, cell;                  /* corner of the grid, and size of its cells [m] */
    double columns, rows, around;       /* a cell lists what is so near to a point of it [m] */
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
    double per_cell;                    /* one by the size of cells */
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
    view.per_cell = 1 / field->cell;
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

static int place_of(double at, double corner, int count)
{
    double place = (at - corner) * view.per_cell;

    return place < 0 ? 0 : place < count ? (int)place : count - 1;
}

/* The first and last column and row of the cells that meet a box. */
static void meet(const struct field *field, const struct box *box, int *range)
{
    range[0] = place_of(box->left, field->x, view.columns);
    range[1] = place_of(box->right, field->x, view.columns);
    range[2] = place_of(box->low, field->y, view.rows);
    range[3] = place_of(box->high, field->y, view.rows);
}

#endif
