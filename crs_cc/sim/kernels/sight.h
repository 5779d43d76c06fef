/* Lines of sight, see sight.c. */
#ifndef CRS_SIGHT_H
#define CRS_SIGHT_H

#include "grid.h"

#define PIECE 2                         /* the length at most of a piece of a line [m] */
#define NEAR 1e-6                       /* far more than rounding errors of places [m] */
#define SWEPT 10000                     /* shapes at most that lines are swept over */

struct line {
    struct point start, end;
};

/* Count the objects that each of some lines meets which begin at the same place, see sweep.c. `work` has room for
   them, and for a box and two integers of each shape. A line for which that needs care is left: its count is negated. */
void __crs_sweep(int count, const struct line *lines, const double *content, int *counts,
                 double *work);

#endif
