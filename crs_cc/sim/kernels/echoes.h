/* The rows of the tables that the kernel of echoes reads, see echoes.c. */
#ifndef CRS_KERNELS_ECHOES_H
#define CRS_KERNELS_ECHOES_H

struct point {
    double x, y;
};

struct ping {
    struct point place, start, axis;
    double half, range, falloff, critical;
    double faces, rounds, crosstalk;       /* how many are its own */
};

struct face {
    struct point start, along;          /* at first both ends, in the world */
    double away, share;                 /* at first its length */
};

struct round {
    struct point middle;
    double radius, share;
};

struct crosstalk_ping {
    struct point place;
    double reported, share;
};

#endif
