/* Beams among many shapes, which lie in the arena sorted by the cells of a grid, see `beam_field.py`. Each
   cell lists all shapes whose bounding boxes it meets, but for segments whose lines pass it; those beyond the
   grid are in cells at its edge. */
#include "beams.h"
#include "grid.h"

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

        double cosine = __builtin_fabs(piece->along.x), sine = __builtin_fabs(piece->along.y);
        double x = cosine * piece->half_length + sine * piece->half_width;
        double y = sine * piece->half_length + cosine * piece->half_width;

        stretch(box, piece->middle.x - x, piece->middle.y - y, 0);
        stretch(box, piece->middle.x + x, piece->middle.y + y, 0);
    }
}

/* The cells that a shape meets, in a byte each: a grid has no more than 129 columns and rows. */
static unsigned cells_of(const struct field *field, int shape)
{
    struct box box;
    int range[4];

    bound(shape, &box);
    box.left -= field->around;
    box.right += field->around;
    box.low -= field->around;
    box.high += field->around;
    meet(field, &box, range);
    return range[0] | range[1] << 8 | range[2] << 16 | (unsigned)range[3] << 24;
}

#define IS_LONG(range) (((range) >> 8 & 255) - ((range) & 255) > 1 && ((range) >> 24) - ((range) >> 16 & 255) > 1)

/* Whether the line of a segment passes a cell further off than `around`; not for cells at the edge. */
static int passes(const struct field *field, const struct segment *segment, int column, int row)
{
    double x = field->x + (column + 0.5) * field->cell - segment->start.x;
    double y = field->y + (row + 0.5) * field->cell - segment->start.y;
    double along_x = segment->end.x - segment->start.x, along_y = segment->end.y - segment->start.y;
    double across = along_x * y - along_y * x, away = field->around + ROOT / 2 * field->cell + ON;

    return column > 0 && column < view.columns - 1 && row > 0 && row < view.rows - 1
        && across * across > away * away * (along_x * along_x + along_y * along_y);
}

int __crs_sort(double *content, int room)
{
    const struct field *field = (const struct field *)content;
    int pass, shape, cell, row, column, total = 0;
    int *first, *lists;
    unsigned *cells;

    open_field(field);
    first = view.first;
    lists = view.lists;
    cells = (unsigned *)view.met;       /* until robots meet shapes */
    for (cell = 0; cell <= view.cells; cell++)
        first[cell] = 0;
    for (shape = 0; shape < view.shapes; shape++)
        cells[shape] = cells_of(field, shape);
    for (pass = 0; pass < 2; pass++) {
        for (shape = view.shapes - 1; shape >= 0; shape--) {
            unsigned range = cells[shape];
            int right = range >> 8 & 255, high = range >> 24;
            int is_long = shape < view.circle && IS_LONG(range);

            for (row = range >> 16 & 255; row <= high; row++)
                for (column = range & 255; column <= right; column++) {
                    if (is_long && passes(field, &view.segments[shape], column, row))
                        continue;
                    cell = row * view.columns + column;
                    if (pass == 0)
                        first[cell]++;
                    else
                        lists[--first[cell]] = shape;
                }
        }
        if (pass > 0)
            break;
        for (cell = 0; cell < view.cells; cell++)
            first[cell] = total += first[cell];
        first[view.cells] = total;
        if ((double *)(lists + total + 1) > content + room)
            return 0;
    }
    return (int)((double *)(lists + total + 1) - content) + 1;
}

/* Whether no beam of a robot at a place can hit a shape, by a test that is quick. */
static int is_behind(const struct segment *segment, double x, double y, double start)
{
    double cross = (segment->start.x - x) * (segment->end.y - y)
        - (segment->start.y - y) * (segment->end.x - x);

    return cross > start * segment->length;
}

static int is_beyond(const struct circle *circle, double x, double y, double reach)
{
    double away_x = circle->middle.x - x, away_y = circle->middle.y - y;
    double radius = circle->radius + reach;

    return away_x * away_x + away_y * away_y > radius * radius;
}

/* Try the shapes of the field that is open with a robot, as far as they can concern it. */
static void look(const struct field *field, int number, double reach)
{
    struct view all = view;
    double x = robots[number].place.x, y = robots[number].place.y, start = fan->start;
    struct box box;
    int range[4], row, k, last;

    box.left = box.right = x;
    box.low = box.high = y;
    stretch(&box, x, y, reach);
    meet(field, &box, range);
    for (row = range[2]; row <= range[3]; row++) {
        k = all.first[row * all.columns + range[0]];
        last = all.first[row * all.columns + range[1] + 1];
        for (; k < last; k++) {
            int shape = all.lists[k];

            if (all.met[shape] == number)
                continue;
            all.met[shape] = number;
            if (shape < all.circle) {
                if (!is_behind(&all.segments[shape], x, y, start))
                    try_segment(number, &all.segments[shape], 0);
            } else if (shape < all.piece) {
                if (!is_beyond(&all.circles[shape - all.circle], x, y, reach))
                    try_circle(number, &all.circles[shape - all.circle], 0);
            } else {
                try_piece(number, &all.pieces[shape - all.piece]);
            }
        }
    }
}

/* Try the shapes of a field with all robots. Pieces, which have fields of their own, matter to robots whose
   beams may start on them. */
static void look_around(const struct field *field, int count)
{
    double reach = fan->start + 4 * ON;
    int i;

    open_field(field);
    if (view.piece > 0)
        reach = fan->reach * (1 + SLACK);
    for (i = 0; i < view.shapes; i++)
        view.met[i] = -1;
    for (i = 0; i < count; i++)
        look(field, i, reach);
}

void __crs_survey(int count, const double *fan_table, double *robot_table, double *out,
                  const double *const *fields)
{
    int i;

    take_fan(fan_table, robot_table);
    distances = out;
    objects = out + count * beam_count;
    prepare(count, count * beam_count, 1);
    for (i = 0; i < FIELDS; i++)
        if (fields[i])
            look_around((const struct field *)fields[i], count);
    for (i = 0; i < count * beam_count; i++)
        if (objects[i] >= 0)
            distances[i] = 0;
}
