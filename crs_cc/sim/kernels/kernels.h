/* What the kernels share: their arrays lie in one arena, which numpy writes and reads, and
   in tables of robots. */
#ifndef CRS_KERNELS_H
#define CRS_KERNELS_H

#define MEMORY 1825000               /* numbers for the arena and the tables */
#define RAY_BINS 256                /* of directions in a turn, see rays.c */
#define SEGMENT_SIZE 7              /* numbers in a row of shapes, see rays.c */
#define CIRCLE_SIZE 5
#define DEVIATES 3                  /* of a firing of a sonar, see `devices/sonar/errors.py` */

/* Sine and cosine of an angle, of the library. */
void __crs_sin_cos(double x, double *sine, double *cosine);

/* Elementwise functions, see functions.c. */
void __crs_apply(int function, int count, double *a, double *b, double *out);

/* The displacement along an arc with a heading before, a length and a change of heading. */
void __crs_arc(double heading, double way, double turn, double *x, double *y);

/* An angle in a turn, as Python's remainder. */
double __crs_in_turn(double angle);

struct battery;
struct body;
struct constants;
struct robot;
struct sonars;

#define NUM_STATE 45

/* What a reply tells of a robot, see report.c. */
struct reply {
    int state[NUM_STATE];
    double charge[2], ms;
};

/* The motion of axes and robots, see drive.c: arrays in columns, changed in place. */
void __crs_profiles(int count, double *columns);
void __crs_counts(int count, double *columns);

/* The tables of robots. */
struct tables {
    struct robot *robots;
    struct body *bodies;
    struct battery *batteries;
    struct constants *kinds;
    struct sonars *sonars;
};

/* What kernels on robots return. */
enum { ADVANCED, SENSOR_DUE, TIMEOUT_DUE, NOT_HANDLED };

/* Kernels on robots: `rows` are their rows in the tables, 0 for the first `count` ones. */
int __crs_advance(int count, int renews, const long long *rows, double last, const double *to,
                  const struct tables *tables);

/* Advance a robot to a time before which nothing happens to it. */
void __crs_move(struct robot *robot, const struct constants *constants, double to);

/* What encoders tell of the motion that a robot's motors drive, if its wheels lag behind so much. */
void __crs_lag(const struct constants *constants, double lag, const double *driven,
               double *counted);

/* Ramp axes to speeds, see drive.c: three numbers of each robot. */
void __crs_speeds(int count, const long long *rows, const double *speeds, const double *ramps,
                  const double *which, const struct tables *tables);

/* What `State` says of motions, see report.c: eight integers of each robot. */
void __crs_reports(int count, const long long *rows, const struct tables *tables, int *out);

/* The same of one robot. */
void __crs_report(const struct robot *robot, const struct constants *constants, int *out);

/* Replies to requests, see report.c; `times` are those for which robots have been in the world. */
void __crs_replies(int count, const long long *rows, const double *times,
                   const struct tables *tables, struct reply *out);

/* What requests of one kind have in common. */
struct service {
    double end, last;                   /* of the cycle; the time up to which sensors matter [s] */
    double command, cycle;              /* the command that sets speeds, 0 for none; now */
};

#define INTEGERS 8                      /* of a message */

/* Answer requests that need nothing but the rows of robots, see requests.c: advance robots to the times
   of theirs, which are brought into the cycle, and run `vm` with the integers of messages. If any of
   them cannot, none is advanced: then return why. `joined` is overwritten, and the integers by where mounts
   are: x, y and direction of each robot's. */
int __crs_serve(int count, const long long *rows, const struct service *service, double *clocks,
                double *joined, int *values, const struct tables *tables, struct reply *out);

/* What the clock of a sensor board shows [ms], see `devices/clock`. */
double __crs_board_ms(double time, double tick);

/* The charges of batteries: two numbers of each robot. */
void __crs_charges(int count, const long long *rows, const double *times,
                   const struct tables *tables, double *out);
int __crs_is_empty(const struct robot *robot, double time, const struct tables *tables);

struct cycle {
    double timestep, end;               /* [s] */
    double is_free;                     /* whether the robots move as their wheels do, or have moved */
    double drains;                      /* whether any wheel turned or was held; negative: find out */
};

/* End a cycle of all robots, see cycle.c. `empty` gets how many robots' batteries ran empty, whether any
   is empty at the end of the next cycle, and which ran empty.
   `before` is where they were; if they move freely that is set here, too. If rounding errors of their
   places are too large, they have moved, but nothing else is done: then return NOT_HANDLED. */
int __crs_finish(int count, const struct cycle *cycle, const double *joined, double *before,
                 const struct tables *tables, int *empty);

/* The first echo of each of some pings, see echoes.c. The tables of shapes are overwritten. */
void __crs_echoes(int count, int absorbing, const double *pings, double *faces, double *rounds,
                  const double *crosstalk, double *out);

/* What sonars report instead of true distances, see sonars.c: columns, changed in place. */
void __crs_errors(int count, double *columns);

/* What the firing of sonars depends on, besides the rows of robots. */
struct surroundings {
    const double *modes, *deviates;     /* of each robot: the first row of its sonars; see errors.py */
    const double *beams;
    const double *segments, *circles;   /* as in rays.c */
    int segment_count, circle_count;
    double *work;                       /* memory for as many faces and rounds */
};

/* Fire the sonars that are due up to a time of each robot, at most one of each, and hear the echoes
   up to then. Return whether another is due, or NOT_HANDLED before anything is changed if a robot may not
   have moved as its wheels did. */
int __crs_fire(int count, const long long *rows, const double *to,
               const struct surroundings *around, const struct tables *tables);

/* The direction of a robot's mount, see `devices/mount.py`. */
double __crs_mount(const struct robot *robot, const struct constants *constants);

/* Run cycles in which nothing but requests for kernels happens, see calm.c; the memory begins with what
   it is told. */
void __crs_calm(double *memory, const struct tables *tables);

/* The distances that beams measure, see rays.c. `out` has the distance of each beam of each robot,
   and then, if they are wanted, the object that each hits. The first call initialises it. */
void __crs_rays(int count, int segments, int circles, int is_first, int wants_objects,
                const double *fan, double *robots, double *out, const double *shapes);

/* The same of all shapes, 0 for beams that start in or on one. The rows of segments, circles and pieces
   lie one after the other. `out` has room for two numbers of each beam. */
void __crs_scan(int count, int segments, int circles, int pieces, const double *fan, double *robots,
                double *out, const double *shapes);

/* Sort shapes by the cells of their grid, see survey.c; return how many numbers they take with their lists,
   0 if there is no room for these. */
int __crs_sort(double *content, int room);

#define FIELDS 4                        /* outlines and pieces that stay, and those that move */

/* The distances that beams measure among sorted shapes, 0 for those that start in or on one. `out` has room
   for two numbers of each beam. A field is 0 if there is nothing in it. */
void __crs_survey(int count, const double *fan, double *robots, double *out, const double *const *fields);

/* How much room each of some discs has among sorted segments and circles, see room.c. `rooms` has the most that
   it may have, and gets what it has. `near` gets for each segment whether a disc has less than it needs. */
void __crs_room(int count, const double *asked, const double *content, double *rooms, int *near);

/* How many objects lie between the ends of each of some lines, two points each, among sorted segments and circles,
   see sight.c. Their objects are numbered from 0 on. `counts` has how many are enough to be told, and gets how many
   there are, up to that. */
void __crs_sight(int count, const double *lines, const double *content, int *counts);

/* Which robots messages are for, from the `first` on, see hearing.c. `told` has the places of all robots and what is
   known of them, `content` those in the world as sorted circles. `work` gets a bit for each robot, and then the
   pairs; there is room for some. `missed` gets for each message whether a robot in range is full, and then how many
   pairs there are. Return before which message the room has ended. */
int __crs_hear(int first, int count, int robots, int room, const double *told, const double *content,
               const double *said, double *work, int *missed);

/* Antennae of robots, and the fields that they smell. */
struct antennae {
    int fields, number;                 /* of fields, and of antennae */
    int is_one, has_poses;              /* whether all robots have the same; whether it is told where they are */
};

/* The cells at the ends of antennae, see fields.c. `content` has the grids of fields, the ends of each antenna
   ahead and to the left, of one robot after the other, and perhaps the poses of robots. `out` gets the tiles, by
   fields, antennae and robots, and then the places in them. */
void __crs_antennae(int count, const long long *rows, const struct antennae *given,
                    const double *content, const struct tables *tables, long long *out);

/* The trails of robots in a timestep, see fields.c. `content` has the grids of fields, their measures, and what is
   known of the robots. `out` gets cells, and from place 64 * `count` on their integers; return how many. */
int __crs_trails(int count, int fields, const double *content, long long *out);

/* The object that each beam of each robot starts in or on, -1 for none, see rays.c. */
void __crs_covers(int count, int pieces, int is_first, const double *fan, double *robots,
                  double *out, const double *shapes);

#endif
