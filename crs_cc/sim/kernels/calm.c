/* Calm time: cycles in which programs ask for nothing but what kernels can answer, and robots touch
   nothing. The kernel answers, ends cycles, and returns whenever programs are to run, which the
   fleet's driver does. What it cannot do it leaves as it was, to Python: see `engine/calm_time.py`.
   The parts are in calm_answers.c, calm_motion.c, and instruments.c. */
#include <math.h>

#include "calm.h"
#include "robot.h"

#define SUSPENDED 1
#define SYSTEM_CALL 1000                /* fuel, as in `requests/door.py` */

static double end_of(const struct calm *calm)
{
    return (double)(calm->cycle + 1) * calm->timestep;
}

/* Send requests over the link; return whether all that programs have asked for can be sent. */
static int send(const struct calm *calm, struct record *records)
{
    int i;

    for (i = 0; i < calm->count; i++) {
        const struct record *each = &records[i];

        if (each->asks && (each->status != SUSPENDED || command_of(calm, each->code) < 0))
            return 0;
    }
    for (i = 0; i < calm->count; i++) {
        struct record *each = &records[i];
        double takes;

        if (!each->asks)
            continue;
        each->asks = 0;
        takes = TABLE(calm, double, links)[CODES * i + each->code];
        if (takes == 0) {
            each->fuel += SYSTEM_CALL;
            each->clock += SYSTEM_CALL / each->speed;
        }
        each->due = each->clock + takes;
    }
    return 1;
}

static int can_run(const struct calm *calm, const struct record *records)
{
    int i;

    for (i = 0; i < calm->count; i++)
        if (records[i].alive && records[i].clock < calm->end && records[i].due == INFINITY)
            return 1;
    return 0;
}

static int is_anybody_alive(const struct calm *calm, const struct record *records)
{
    int i;

    for (i = 0; i < calm->count; i++)
        if (records[i].alive)
            return 1;
    return 0;
}

static int moves(const struct calm *calm, const struct tables *tables)
{
    int i, axis;

    for (i = 0; i < calm->count; i++)
        for (axis = 0; axis < AXES; axis++)
            if (tables->robots[i].slice[axis] != 0)
                return 1;
    return 0;
}

/* Advance axes, and fire sonars, up to the end of the cycle; return RUN when that is done. */
static int advance(struct calm *calm, const struct tables *tables)
{
    static double to[MOST];
    const long long *rows = TABLE(calm, const long long, rows);
    double last = nextafter(calm->end, 0);
    int i, count = (int)calm->present, found;

    for (i = 0; i < count; i++)
        to[i] = calm->end;
    found = __crs_advance(count, 0, rows, last, to, tables);
    if (found == SENSOR_DUE) {
        for (i = 0; i < count; i++)
            to[i] = last;
        found = __crs_calm_fire(calm, count, rows, to, tables);
        if (found != RUN)
            return found;
        for (i = 0; i < count; i++)
            to[i] = calm->end;
        found = __crs_advance(count, 0, rows, last, to, tables);
    }
    return found == ADVANCED ? RUN : REFUSED;
}

/* End the cycle that programs have used up; return RUN, or what prevents it. */
static int end_cycle(struct calm *calm, const struct record *records, const struct tables *tables)
{
    int found = advance(calm, tables), stands;

    if (found != RUN)
        return found;
    stands = !moves(calm, tables) && !calm->served;
    if (!__crs_calm_move(calm, tables))
        return REFUSED;
    calm->cycle++;
    calm->ended++;
    calm->end = end_of(calm);
    calm->rounds = 0;
    calm->was_served = calm->served;
    calm->served = 0;
    if (!calm->keeps)
        calm->answer_count = 0;
    if (calm->cycle >= calm->until || !is_anybody_alive(calm, records))
        return DONE;
    return calm->is_weary ? REFUSED : stands ? STANDS : RUN;
}

/* Go on after programs have run; return why. */
static int go_on(struct calm *calm, const struct tables *tables)
{
    struct record *records = TABLE(calm, struct record, records);
    int found;

    if (calm->ran > 0)
        calm->rounds += calm->ran;
    if (!send(calm, records))
        return ASKED;
    for (;;) {
        found = __crs_calm_serve(calm, tables);
        if (found != RUN)
            return found;
        if (can_run(calm, records))
            return RUN;
        if (calm->cycle >= calm->until)
            return DONE;                /* the cycle, which is used up, is not to be ended */
        if (calm->frame_room && (calm->ended + 1) * calm->count > calm->frame_room)
            return FULL;
        found = end_cycle(calm, records, tables);
        if (found != RUN)
            return found;
    }
}

void __crs_calm(double *memory, const struct tables *tables)
{
    struct calm *calm = (struct calm *)memory;

    calm->end = end_of(calm);
    calm->verdict = go_on(calm, tables);
}
