/*
 * patrol.h - shared declarations of the night watch.
 *
 * The variables are defined by being declared: each file that includes this has
 * them "in common", as the linkers of the time understood it.
 */

# include <stdio.h>
# include "Nclient.h"

# define ROBOT_ID     1
# define N_SONARS     16
# define INCHES(n)    ((n) * 10L)          /* State is in tenths */
# define DEGREES(n)   ((n) * 10)

struct door {
    char *name;
    long where;                            /* along the corridor, 0.1 inch from home */
    int side;                              /* degrees to turn from the corridor */
    int state;                             /* UNKNOWN until visited */
    int depth;                             /* sonar reading, inches */
};

# define UNKNOWN      0
# define OPEN         1
# define CLOSED       2

/* main.c */
struct door *doors;
int n_doors;

/* motion.c */
int bumps;                                 /* contacts since the start */
int go_to(), face(), halt();

/* sense.c */
int ring[N_SONARS];                        /* the last full ring, inches */
int look(), clear_ahead();
char *state_name();

/* watch.c */
long minutes, seconds;                     /* since the start, as of the last tick() */
int tick();
