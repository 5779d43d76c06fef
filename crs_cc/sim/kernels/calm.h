/* Calm time: whole cycles of few robots without Python, see calm.c. Numbers of eight bytes each, in the
   order of `kernels/calm.py`. */
#ifndef CRS_KERNELS_CALM_H
#define CRS_KERNELS_CALM_H

#include <crs_request.h>

#include "kernels.h"

#define CODES 256                       /* codes of requests are smaller */
#define MOST 64                         /* robots */

/* Why the kernel returns: programs are to run; or a program has asked for something else; something
   is due that kernels do not know; `until` is reached; there is no more room for what is logged; or no
   deviate for a measurement; nothing has moved and nothing was asked. */
enum { RUN, ASKED, REFUSED, DONE, FULL, DRAWN, STANDS };

/* A slot and its timing, see `requests/door.py`. */
struct record {
    int run, status, code, error[3];
    long long rest, statements, stop_from;
    int error_size, stop_all, stopped, error_base;
    struct __crs_message message;
    double clock, due, speed;
    long long fuel, pending;
    unsigned char alive;
    int asks, compared[4];
};

struct answer {
    double clock;
    int code, robot, state[45], batch;
    long long cycle;
    int result, arguments[8], padding;
};

/* Where a robot is at the end of a cycle, and where it believes to be. */
struct frame {
    double x, y, heading, turret, believed[3];
};

/* Deviates of the next measurements of some sensors: those of each from its number `first` on, of as many
   of them as there are draws, 0 if they have no errors. */
struct drawn {
    long long first, deviates, draws;
};

struct calm {
    int verdict, ran;                   /* why it returned; rounds of programs since, -1 for none */
    double end;                         /* of the cycle */
    /* What it is told. The tables are at these places from here on. Those of segments, circles and pieces
       lie one after the other. */
    long long records, rows, joined, called, modes, mistakes, beams, segments, circles, pieces, work,
        links, commands, measures, most, volts, volts_of, ring_of, rings, fans, compass_of, compasses,
        backup, frames, answers;
    struct drawn sonar, ring, compass;
    long long count, present, segment_count, circle_count, piece_count;
    long long frame_room, answer_room;  /* 0 for no frames */
    long long keeps;                    /* whether answers of earlier cycles are kept */
    long long until;                    /* the cycle before which it ends */
    long long laser_count, batteries, board_ms;     /* places in messages */
    double timestep, slop;
    /* What it changes. */
    long long cycle;
    double room;                        /* that robots have, see `physics/simulation.py` */
    double goal_room;                   /* and until a goal has to be judged, see `engine/goals.py` */
    long long rounds;                   /* of programs in this cycle */
    long long ended;                    /* cycles */
    long long answer_count, batch;
    long long served, was_served;       /* requests in this cycle, and in the one before */
    long long is_weary;
};

/* A table that it is told of. */
#define TABLE(calm, type, name) ((type *)((double *)(calm) + (calm)->name))

/* Return the command of a request that kernels answer, 0 for none, or -1 if they do not. */
static inline int command_of(const struct calm *calm, int code)
{
    return code >= 0 && code < CODES ? (int)TABLE(calm, double, commands)[code] : -1;
}

/* Return the deviates of a measurement of a sensor, so many of them, or 0 if they are not known. */
const double *__crs_drawn(const struct calm *calm, const struct drawn *drawn, long long sensor,
                          long long number, int width);

/* Fire and hear sonars up to times; return RUN when that is done. */
int __crs_calm_fire(struct calm *calm, int count, const long long *rows, const double *to,
                    const struct tables *tables);

/* Answer all requests that arrive in this cycle, by rising codes; return RUN when that is done. */
int __crs_calm_serve(struct calm *calm, const struct tables *tables);

/* Move bodies at the end of a cycle, as nothing is near; return whether that is all, else change nothing. */
int __crs_calm_move(struct calm *calm, const struct tables *tables);

/* Which instruments a request makes measure: those that it is about, or those that masks select. */
enum { RINGS = 1, COMPASSES = 2, MASKED = 4 };

/* Return whether the deviates of the next measurement of a robot's instruments are known. */
int __crs_are_known(const struct calm *calm, long long robot);

/* Measure with a robot's instruments, some kinds of them, for a request at a time. */
void __crs_measure(struct calm *calm, long long robot, int kinds, double at,
                   const struct tables *tables);

/* Write what instruments have measured last into `State`. */
void __crs_tell(const struct calm *calm, long long robot, int *state);

#endif
