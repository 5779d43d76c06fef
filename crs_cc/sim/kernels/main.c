/* Serves calls of kernels: waits for one in a request, as robots' programs wait for replies. */
#include <crs_request.h>

#include "kernels.h"
#include "robot.h"

/* Other numbers are those of elementwise functions. */
enum { SETUP = 99, ECHOES, RAYS, PROFILES, COUNTS, ADVANCE, REPORTS, COVERS, RENEW, SPEEDS, REPLIES,
    CHARGES, FINISH, SCAN, SERVE, FIRE, ERRORS, CALM, SORT, SURVEY, ANTENNAE, TRAILS, ROOM, SIGHT,
    HEAR };

static int arguments[10];
static double memory[MEMORY];
static double *arena;
static int block;               /* numbers in a third of the arena */
static struct tables tables;

/* Divide the memory into the arena and the tables, whose numbers of rows are given. */
static void set_up(int *n)
{
    block = n[1];
    arena = memory;
    tables.robots = (struct robot *)(memory + 3 * block);
    tables.bodies = (struct body *)(tables.robots + n[2]);
    tables.batteries = (struct battery *)(tables.bodies + n[3]);
    tables.kinds = (struct constants *)(tables.batteries + n[2]);
    tables.sonars = (struct sonars *)(tables.kinds + n[4]);
    n[0] = (int)arena;
    n[1] = (int)tables.robots;
    n[2] = (int)tables.bodies;
    n[3] = (int)tables.batteries;
    n[4] = (int)tables.kinds;
    n[5] = (int)tables.sonars;
}

/* Fire sonars: behind the times of the robots are the numbers that they depend on. */
static int fire(const int *n, int count, const long long *rows, const double *numbers)
{
    struct surroundings around;

    around.modes = numbers + count;
    around.deviates = around.modes + count;
    around.beams = around.deviates + DEVIATES * count;
    around.segments = around.beams + n[3];
    around.segment_count = n[4];
    around.circles = around.segments + n[4] * SEGMENT_SIZE;
    around.circle_count = n[5];
    around.work = (double *)around.circles + n[5] * CIRCLE_SIZE;
    return __crs_fire(count, rows, numbers, &around, &tables);
}

/* Find what antennae smell; the cells come behind the numbers. */
static void smell(const int *n, const long long *rows, const double *numbers)
{
    struct antennae given = { n[3], n[4], n[5], n[6] };

    __crs_antennae(n[1], rows, &given, numbers, &tables, (long long *)(arena + n[7]));
}

/* Run a kernel on some robots. Their rows come first in the arena, unless it is about the first ones;
   then numbers. */
static void run_on_robots(int *n)
{
    int count = n[1];
    const long long *rows = n[2] ? (const long long *)arena : 0;
    double *numbers = arena + (n[2] ? count : 0), *out = arena + block;

    switch (n[0]) {
    case ADVANCE:
    case RENEW:
        n[0] = __crs_advance(count, n[0] == RENEW, rows, numbers[0], numbers + 1, &tables);
        break;
    case REPORTS:
        __crs_reports(count, rows, &tables, (int *)out);
        break;
    case REPLIES:
        __crs_replies(count, rows, numbers, &tables, (struct reply *)out);
        break;
    case SERVE:
        n[0] = __crs_serve(count, rows, (struct service *)numbers, numbers + 4, numbers + 4 + count,
                           (int *)(numbers + 4 + 2 * count), &tables, (struct reply *)out);
        break;
    case FIRE:
        n[0] = fire(n, count, rows, numbers);
        break;
    case CHARGES:
        __crs_charges(count, rows, numbers, &tables, out);
        break;
    case ANTENNAE:
        smell(n, rows, numbers);
        break;
    case SPEEDS:
        __crs_speeds(count, rows, numbers, n[3] ? numbers + n[3] : 0, n[4] ? numbers + n[4] : 0,
                     &tables);
        break;
    case FINISH:
        n[0] = __crs_finish(count, (struct cycle *)numbers, numbers + 4, numbers + 4 + count,
                            &tables, (int *)out);
        break;
    }
}

/* Cast rays, or find what covers their starts, or both. */
static void cast(const int *n)
{
    double *robot = arena + n[6], *out = arena + n[7], *shapes = arena + n[8];

    if (n[0] == RAYS)
        __crs_rays(n[1], n[2], n[3], n[4], n[5], arena, robot, out, shapes);
    else if (n[0] == COVERS)
        __crs_covers(n[1], n[2], n[4], arena, robot, out, shapes);
    else
        __crs_scan(n[1], n[2], n[3], n[9], arena, robot, out, shapes);
}

/* Cast rays among sorted shapes. */
static void survey(const int *n)
{
    const double *fields[FIELDS];
    int i;

    for (i = 0; i < FIELDS; i++)
        fields[i] = n[4 + i] ? arena + n[4 + i] : 0;
    __crs_survey(n[1], arena, arena + n[2], arena + n[3], fields);
}

int __crs_start(void)
{
    static struct __crs_message message;
    int *n = arguments;

    message.i[0] = (int)arguments;
    for (;;) {
        __crs_request(1, &message);
        if (n[0] == SETUP)
            set_up(n);
        else if (n[0] == ECHOES)
            __crs_echoes(n[1], n[2], arena, arena + n[3], arena + n[4], arena + n[5],
                         arena + n[6]);
        else if (n[0] == RAYS || n[0] == COVERS || n[0] == SCAN)
            cast(n);
        else if (n[0] == PROFILES)
            __crs_profiles(n[1], arena);
        else if (n[0] == COUNTS)
            __crs_counts(n[1], arena);
        else if (n[0] == ERRORS)
            __crs_errors(n[1], arena);
        else if (n[0] == SORT)
            n[0] = __crs_sort(arena + n[1], n[2]);
        else if (n[0] == SURVEY)
            survey(n);
        else if (n[0] == ROOM)
            __crs_room(n[1], arena, arena + n[4], arena + n[2], (int *)(arena + n[3]));
        else if (n[0] == SIGHT)
            __crs_sight(n[1], arena, arena + n[2], (int *)(arena + n[3]));
        else if (n[0] == HEAR)
            n[0] = __crs_hear(n[1], n[2], n[3], n[4], arena, arena + n[5], arena + n[6], arena + n[7],
                              (int *)(arena + n[8]));
        else if (n[0] == TRAILS)
            n[0] = __crs_trails(n[1], n[2], arena, (long long *)(arena + n[3]));
        else if (n[0] == CALM)
            __crs_calm(arena, &tables);
        else if (n[0] > COUNTS)
            run_on_robots(n);
        else
            __crs_apply(n[0], n[1], arena, arena + block, arena + 2 * block);
    }
}
