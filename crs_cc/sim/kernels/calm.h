/* Calm time: whole cycles of few robots without Python, see calm.c. Numbers of eight bytes each, in the
   order of `kernels/calm.py`. */
#ifndef CRS_KERNELS_CALM_H
#define CRS_KERNELS_CALM_H

#include <crs_request.h>

#define CODES 256                       /* codes of requests are smaller */
#define MOST 64                         /* robots */

/* Why the kernel returns: programs are to run; or a program has asked for something else; something
   is due that kernels do not know; `until` is reached; there is no more room for what is logged; or no
   deviate for a firing; nothing has moved and nothing was asked. */
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

struct calm {
    int verdict, ran;                   /* why it returned; rounds of programs since, -1 for none */
    double end;                         /* of the cycle */
    /* What it is told. The tables are at these places in the arena. */
    long long records, rows, joined, called, modes, first, deviates, mistakes, beams, segments,
        circles, work, links, commands, most, volts, volts_of, backup, frames, answers;
    long long count, present, segment_count, circle_count;
    long long draws;                    /* firings of each robot whose deviates are known, 0 for no errors */
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

#endif
