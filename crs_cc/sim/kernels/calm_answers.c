/* Requests in calm time, see calm.c: what they need is done, and replies are written. */
#include <math.h>

#include "calm.h"
#include "robot.h"

#define STEPS 1000                      /* of charge, see `battery/supplies.py` */

/* Write a reply, and log it. */
static void reply(struct calm *calm, long long robot, int code, double clock,
                  const struct reply *told)
{
    struct record *to = &TABLE(calm, struct record, records)[robot];
    struct __crs_message *message = &to->message;
    struct answer *log = TABLE(calm, struct answer, answers) + calm->answer_count++;
    const int *volts = TABLE(calm, const int, volts);
    const long long *volts_of = TABLE(calm, const long long, volts_of) + 2 * robot;
    int i;

    for (i = 0; i < INTEGERS; i++)
        log->arguments[i] = message->i[i];
    message->i[calm->laser_count] = 0;
    for (i = 0; i < 2; i++) {
        int step = (int)(told->charge[i] * STEPS + 0.5);

        message->i[calm->batteries + i] = volts[volts_of[i] + step];
    }
    message->f[calm->board_ms] = told->ms;
    for (i = 0; i < NUM_STATE; i++)
        log->state[i] = told->state[i];
    for (i = 0; i < NUM_STATE; i++)
        ((int *)message->data)[i] = told->state[i];
    message->size = sizeof told->state;
    message->result = 1;
    TABLE(calm, double, called)[robot] = to->due;
    to->clock = clock;
    to->due = INFINITY;
    log->cycle = calm->cycle;
    log->clock = clock;
    log->batch = (int)calm->batch;
    log->code = code;
    log->robot = (int)robot;
    log->result = 1;
    log->padding = 0;
}

/* Return whether speeds are above a robot's limits, which users are told once. */
static int is_too_fast(const struct calm *calm, long long robot, const int *speeds)
{
    const double *most = TABLE(calm, const double, most) + AXES * robot;
    int axis;

    for (axis = 0; axis < AXES; axis++)
        if (__builtin_fabs(speeds[axis]) > most[axis])
            return 1;
    return 0;
}

/* Requests with the same code, in the order of robots. */
struct batch {
    int code, count, values[MOST * INTEGERS];
    long long robots[MOST];
    double clocks[MOST], joined[MOST];
};

/* Gather the requests with a code that arrive in this cycle; return whether all can be answered. */
static int gather(const struct calm *calm, int command, struct batch *batch)
{
    const struct record *each = TABLE(calm, const struct record, records);
    int i, k;

    batch->count = 0;
    for (i = 0; i < calm->count; i++, each++) {
        int place = batch->count;

        if (each->code != batch->code || !(each->due < calm->end))
            continue;
        if (command == CRS_VM && is_too_fast(calm, i, each->message.i))
            return 0;
        batch->robots[place] = i;
        batch->clocks[place] = each->due;
        batch->joined[place] = TABLE(calm, const double, joined)[i];
        for (k = 0; k < INTEGERS; k++)
            batch->values[INTEGERS * place + k] = each->message.i[k];
        batch->count++;
    }
    return 1;
}

/* Fire the sonars that are due before requests; return RUN when that is done. */
static int fire(struct calm *calm, const struct batch *batch, double last,
                const struct tables *tables)
{
    static double to[MOST];
    int i;

    for (i = 0; i < batch->count; i++)
        to[i] = batch->clocks[i] < last ? batch->clocks[i] : last;
    return __crs_calm_fire(calm, batch->count, batch->robots, to, tables);
}

/* Execute requests; return RUN when that is done. */
static int execute(struct calm *calm, int command, struct batch *batch,
                   const struct tables *tables, struct reply *told)
{
    struct service service = { calm->end, nextafter(calm->end, 0), command, calm->cycle };
    int again, found;

    for (again = 0; again < 2; again++) {
        found = __crs_serve(batch->count, batch->robots, &service, batch->clocks, batch->joined,
                            batch->values, tables, told);
        if (found != SENSOR_DUE)
            break;
        found = again ? REFUSED : fire(calm, batch, service.last, tables);
        if (found != RUN)
            return found;
    }
    return found == ADVANCED ? RUN : REFUSED;
}

/* Answer the requests with a code that arrive in this cycle; return RUN when that is done. */
static int serve(struct calm *calm, int code, const struct tables *tables)
{
    static struct batch batch;
    static struct reply told[MOST];
    int command = command_of(calm, code), measures, i, found;

    batch.code = code;
    if (command < 0 || !gather(calm, command, &batch))
        return REFUSED;
    measures = (int)TABLE(calm, double, measures)[code];
    for (i = 0; measures && i < batch.count; i++)
        if (!__crs_are_known(calm, batch.robots[i]))
            return DRAWN;
    found = execute(calm, command, &batch, tables, told);
    if (found != RUN)
        return found;
    calm->batch++;
    calm->served += batch.count;
    for (i = 0; i < batch.count; i++) {
        __crs_measure(calm, batch.robots[i], measures, batch.clocks[i], tables);
        __crs_tell(calm, batch.robots[i], told[i].state);
        reply(calm, batch.robots[i], code, batch.clocks[i], &told[i]);
    }
    return RUN;
}

int __crs_calm_serve(struct calm *calm, const struct tables *tables)
{
    const struct record *records = TABLE(calm, const struct record, records);
    int found, i;

    for (;;) {
        int code = -1;

        for (i = 0; i < calm->count; i++)
            if (records[i].due < calm->end && (code < 0 || records[i].code < code))
                code = records[i].code;
        if (code < 0)
            return RUN;
        if (calm->answer_count + calm->count > calm->answer_room)
            return FULL;
        found = serve(calm, code, tables);
        if (found != RUN)
            return found;
    }
}
