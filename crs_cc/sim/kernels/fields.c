/* Places in pheromone fields: the cells at the ends of antennae, see `devices/antennae`, and those that robots lay
   trails in, see `devices/gland`. What lies in the cells is not here: it grows without a limit that kernels know. */
#include <math.h>

#include "kernels.h"
#include "robot.h"

#define SIDE 8                          /* of a tile [cells], see `geometry/field_grid.py` */
#define TILE (SIDE * SIDE)
#define NOWHERE (-1)                    /* the tile outside of the area */
#define PIECES 64                       /* of a timestep's trail, at most */
#define SLACK 1e-6                      /* of a straight way against the distance driven [m] */

/* The cells of a field: the corner of the area, and their side [m]; their numbers along the sides of the
   area; tiles in a row of tiles, and the number of the first one. */
struct grid {
    double x, y, cell, columns, rows, across, first;
};

/* What is laid into a field: the largest amount, and the amount that an integer stands for. */
struct measure {
    double most, unit;
};

/* Find the tile of a place; return the place in the tile. */
static int find(const struct grid *grid, double x, double y, long long *tile)
{
    double across = (x - grid->x) / grid->cell, up = (y - grid->y) / grid->cell;
    unsigned column, row;

    if (!(across >= 0 && across < grid->columns && up >= 0 && up < grid->rows)) {
        *tile = NOWHERE;
        return TILE - 1;                /* of the tile before the first one: cell -1 */
    }
    column = (unsigned)across;
    row = (unsigned)up;
    *tile = row / SIDE * (unsigned)grid->across + column / SIDE + (unsigned)grid->first;
    return row % SIDE * SIDE + column % SIDE;
}

/* The pose of a robot's mount, see `devices/mount.py`. */
static void look_up(const struct tables *tables, int row, double *pose)
{
    const struct robot *robot = &tables->robots[row];
    const struct body *body = &tables->bodies[row];
    const struct constants *own = &tables->kinds[(int)robot->kind];

    pose[0] = body->x + (robot->slipping ? 0 : robot->moved[0]);
    pose[1] = body->y + (robot->slipping ? 0 : robot->moved[1]);
    pose[2] = own->has_turret != 0 ? robot->turret
        : own->is_synchro != 0 ? robot->base : robot->facing;
}

void __crs_antennae(int count, const long long *rows, const struct antennae *given,
                    const double *content, const struct tables *tables, long long *out)
{
    const struct grid *grids = (const struct grid *)content, *last = grids + given->fields, *grid;
    const double *ends = (const double *)last, *end;
    int places = given->is_one ? 1 : count, each = given->number * count, i, k;
    int cells = given->fields * each;
    const double *poses = ends + 2 * given->number * places;

    for (i = 0; i < count; i++) {
        double pose[3], ahead_x, ahead_y;

        if (given->has_poses) {
            pose[0] = poses[3 * i];
            pose[1] = poses[3 * i + 1];
            pose[2] = poses[3 * i + 2];
        } else
            look_up(tables, rows ? (int)rows[i] : i, pose);
        __crs_sin_cos(pose[2], &ahead_y, &ahead_x);
        end = given->is_one ? ends : ends + i;
        for (k = 0; k < given->number; k++, end += 2 * places) {
            double ahead = end[0], left = end[places];
            double x = pose[0] + (ahead_x * ahead - ahead_y * left);
            double y = pose[1] + (ahead_y * ahead + ahead_x * left);
            long long *tile = out + k * count + i;

            for (grid = grids; grid < last; grid++, tile += each)
                tile[cells] = find(grid, x, y, tile);
        }
    }
}

int __crs_trails(int count, int fields, const double *content, long long *out)
{
    const struct grid *grids = (const struct grid *)content, *grid;
    const struct measure *measures = (const struct measure *)(grids + fields), *measure;
    const double *at = (const double *)(measures + fields), *from = at + 2 * count;
    const double *moved = from + 2 * count, *per_m = moved + count;
    const long long *field = (const long long *)(per_m + count);
    long long *cell = out, *deposit = out + PIECES * count, tile;
    int i, number, place, carried;

    for (i = 0; i < count; i++, at += 2, from += 2) {
        double way_x = at[0] - from[0], way_y = at[1] - from[1], pieces, amount;
        double straight = __builtin_sqrt(way_x * way_x + way_y * way_y);

        grid = &grids[field[i]];
        measure = &measures[field[i]];
        carried = !(straight <= moved[i] + SLACK);      /* NaN: it is new in the world */
        pieces = __builtin_ceil(straight / grid->cell);
        pieces = pieces <= PIECES ? pieces > 1 ? pieces : 1 : PIECES;
        amount = per_m[i] * moved[i] / pieces;
        amount = __builtin_rint((amount < measure->most ? amount : measure->most) / measure->unit);
        for (number = 0; number < pieces; number++) {
            double back = 1 - (number + 0.5) / pieces;

            place = find(grid, at[0] - (carried ? 0 : way_x) * back,
                         at[1] - (carried ? 0 : way_y) * back, &tile);
            if (tile == NOWHERE)
                continue;
            *cell++ = tile * TILE + place;
            *deposit++ = (long long)amount;
        }
    }
    return (int)(cell - out);
}
