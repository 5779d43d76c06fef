/* What the kernels share: their arrays lie in one arena, which numpy writes and reads. */
#ifndef CRS_KERNELS_H
#define CRS_KERNELS_H

#define BLOCK 0x20000               /* elements of an array; complex numbers are two doubles each */
#define ROBOTS 11000                /* rows of the tables of robots */
#define RAY_BINS 256                /* of directions in a turn, see rays.c */

/* Elementwise functions, see functions.c. */
void __crs_apply(int function, int count, double *a, double *b, double *out);

/* The displacement along an arc with a heading before, a length and a change of heading. */
void __crs_arc(double heading, double way, double turn, double *x, double *y);

struct drive;
struct robot;

/* The motion of axes and robots, see drive.c: arrays in columns, changed in place. */
void __crs_profiles(int count, double *columns);
void __crs_counts(int count, double *columns);

/* What `__crs_advance` returns. */
enum { ADVANCED, SENSOR_DUE, TIMEOUT_DUE, HELD_UP };

/* Kernels on robots: `rows` are their rows in the tables, 0 for the first `count` ones. */
int __crs_advance(int count, int renews, const long long *rows, double last, const double *to,
                  const struct drive *drives, struct robot *robots);

/* What `State` says of motions, see report.c: eight integers of each robot. */
void __crs_reports(int count, const long long *rows, const struct drive *drives,
                   const struct robot *robots, int *out);

/* The first echo of each of some pings, see echoes.c. The tables of shapes are overwritten. */
void __crs_echoes(int count, int hushed, const double *pings, double *faces, double *rounds,
                  const double *voices, double *out);

/* The distances that beams measure, see rays.c. `out` has the distance of each beam of each robot,
   and then, if they are wanted, the object that each hits. The first call initialises it. */
void __crs_rays(int count, int segments, int circles, int is_first, int wants_objects,
                const double *fan, double *robots, double *out, const double *shapes);

/* The object that each beam of each robot starts in or on, -1 for none, see rays.c. */
void __crs_covers(int count, int pieces, int is_first, const double *fan, double *robots,
                  double *out, const double *shapes);

#endif
