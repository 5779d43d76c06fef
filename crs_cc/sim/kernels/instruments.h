/* Instruments that measure for replies, see instruments.c, in the order of `kernels/tables.py`. */
#ifndef CRS_KERNELS_INSTRUMENTS_H
#define CRS_KERNELS_INSTRUMENTS_H

#include "robot.h"

#define RAYS 16                         /* of an infrared ring */

/* What they have in common. */
struct instrument {
    double interval, noise;             /* the shortest between measurements [s]; of a value */
    double on_request;                  /* whether it has no timer */
    double masked;                      /* whether the program's mask selects it */
    double at;                          /* when it measured last, negative for never */
    long long count;
    int configuration[CONFIGURATION + 1];       /* of its robot then */
};

/* See `devices/infrared`. */
struct ring {
    struct instrument common;
    double step, fan, share;            /* the place of its beams among `fans` */
    double on[RAYS], level[RAYS];
};

/* See `devices/compass`. */
struct compass {
    struct instrument common;
    double offset, deviation, on, reading;
};

#endif
