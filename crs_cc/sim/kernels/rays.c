/* The distances that beams measure, and what covers their starts: of pairs of a robot and a shape. */
#include "beams.h"

/* Each shape is tried with one robot or with all. */
#define FOR_ROBOTS(i, shape, count)                                             \
    for (i = (shape)->robot < 0 ? 0 : (int)(shape)->robot;                      \
         i < ((shape)->robot < 0 ? (count) : (int)(shape)->robot + 1); i++)

void __crs_rays(int count, int segments, int circles, int is_first, int wants_objects,
                const double *fan_table, double *robot_table, double *out, const double *shapes)
{
    const struct segment *segment = (const struct segment *)shapes;
    const struct circle *circle = (const struct circle *)(segment + segments);
    int i;

    take_fan(fan_table, robot_table);
    distances = out;
    objects = out + count * beam_count;
    if (is_first)
        prepare(count, count * beam_count, wants_objects);
    for (; segments > 0; segments--, segment++)
        FOR_ROBOTS(i, segment, count)
            try_segment(i, segment, wants_objects);
    for (; circles > 0; circles--, circle++)
        FOR_ROBOTS(i, circle, count)
            try_circle(i, circle, wants_objects);
}

void __crs_covers(int count, int pieces, int is_first, const double *fan_table,
                  double *robot_table, double *out, const double *shapes)
{
    const struct piece *piece = (const struct piece *)shapes;
    int i;

    take_fan(fan_table, robot_table);
    objects = out;
    if (is_first)
        prepare(count, 0, 1);
    for (; pieces > 0; pieces--, piece++)
        FOR_ROBOTS(i, piece, count)
            try_piece(i, piece);
}

void __crs_scan(int count, int segments, int circles, int pieces, const double *fan_table,
                double *robot_table, double *out, const double *shapes)
{
    int beams = count * (int)fan_table[0], i;
    double *covers = out + beams;

    __crs_rays(count, segments, circles, 1, 0, fan_table, robot_table, out, shapes);
    for (i = 0; i < beams; i++)
        covers[i] = -1;
    shapes += segments * SEGMENT_SIZE + circles * CIRCLE_SIZE;
    __crs_covers(count, pieces, 0, fan_table, robot_table, covers, shapes);
    for (i = 0; i < beams; i++)
        if (covers[i] >= 0)
            out[i] = 0;
}
