/* Calm time: cycles in which programs ask for nothing but what kernels can answer, and robots touch
   nothing. The kernel answers, ends cycles, and returns whenever programs are to run, which the
   fleet's driver does. What it cannot do it leaves as it was, to Python: see `engine/calm_time.py`. */
#include <math.h>

#include "calm.h"
#include "echoes.h"
#include "kernels.h"
#include "robot.h"

#define SUSPENDED 1
#define SYSTEM_CALL 1000                /* fuel, as in `requests/door.py` */
#define STEPS 1000                      /* of charge, see `battery/supplies.py` */

/* What it works on. */
static struct calm *calm;
static double *arena;
static const struct tables *tables;
static struct record *records;
static const long long *rows;           /* the robots that are present */

static double at_least(double a, double b)
{
    return a > b ? a : b;
}

static double at_most(double a, double b)
{
    return a < b ? a : b;
}

static double end_of(long long cycle)
{
    return (double)(cycle + 1) * calm->timestep;
}

/* Return the command of a request that kernels answer, 0 for none, or -1 if they do not. */
static int command_of(int code)
{
    return code >= 0 && code < CODES ? (int)arena[calm->commands + code] : -1;
}

/* -- what programs have asked for --------------------------------------------------------------- */

/* Send requests over the link; return whether all that programs have asked for can be sent. */
static int send(void)
{
    int i;

    for (i = 0; i < calm->count; i++) {
        const struct record *each = &records[i];

        if (each->asks && (each->status != SUSPENDED || command_of(each->code) < 0))
            return 0;
    }
    for (i = 0; i < calm->count; i++) {
        struct record *each = &records[i];
        double takes;

        if (!each->asks)
            continue;
        each->asks = 0;
        takes = arena[calm->links + CODES * i + each->code];
        if (takes == 0) {
            each->fuel += SYSTEM_CALL;
            each->clock += SYSTEM_CALL / each->speed;
        }
        each->due = each->clock + takes;
    }
    return 1;
}

static int can_run(void)
{
    int i;

    for (i = 0; i < calm->count; i++)
        if (records[i].alive && records[i].clock < calm->end && records[i].due == INFINITY)
            return 1;
    return 0;
}

static int is_anybody_alive(void)
{
    int i;

    for (i = 0; i < calm->count; i++)
        if (records[i].alive)
            return 1;
    return 0;
}

/* -- sonars ------------------------------------------------------------------------------------- */

/* Set what the firing of sonars depends on; return whether it is all known. */
static int look_around(int count, const long long *some, const double *to,
                       struct surroundings *around)
{
    static double modes[MOST], deviates[MOST * DEVIATES];
    const double *mode = arena + calm->modes, *known = arena + calm->deviates;
    const double *mistakes = arena + calm->mistakes;
    const long long *first = (const long long *)(arena + calm->first);
    int i, k;

    for (i = 0; i < count; i++) {
        long long row = some[i], number = tables->sonars[row].count - first[row];

        modes[i] = mode[row];
        if (tables->robots[row].fires > to[i] || calm->draws == 0)
            continue;
        if (number < 0 || number >= calm->draws)
            return DRAWN;
        for (k = 0; k < DEVIATES; k++)
            deviates[DEVIATES * i + k] = known[(row * calm->draws + number) * DEVIATES + k];
        if (deviates[DEVIATES * i + 2] < mistakes[(int)mode[row] + tables->sonars[row].mode])
            return REFUSED;
    }
    around->modes = modes;
    around->deviates = deviates;
    around->beams = arena + calm->beams;
    around->segments = arena + calm->segments;
    around->circles = arena + calm->circles;
    around->segment_count = (int)calm->segment_count;
    around->circle_count = (int)calm->circle_count;
    around->work = arena + calm->work;
    return RUN;
}

/* Fire and hear sonars up to times; return RUN when that is done. */
static int fire(int count, const long long *some, const double *to)
{
    struct surroundings around;
    int i, found;

    for (i = 0; i < count; i++)
        if (tables->robots[some[i]].timer <= to[i])
            return REFUSED;
    do {
        found = look_around(count, some, to, &around);
        if (found != RUN)
            return found;
        found = __crs_fire(count, some, to, &around, tables);
    } while (found == SENSOR_DUE);
    return found == ADVANCED ? RUN : REFUSED;
}

/* -- requests ----------------------------------------------------------------------------------- */

/* Write a reply, and log it. */
static void reply(long long robot, int code, double clock, const struct reply *told)
{
    struct record *to = &records[robot];
    struct __crs_message *message = &to->message;
    struct answer *log = (struct answer *)(arena + calm->answers) + calm->answer_count++;
    const int *volts = (const int *)(arena + calm->volts);
    const long long *volts_of = (const long long *)(arena + calm->volts_of) + 2 * robot;
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
    arena[calm->called + robot] = to->due;
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
static int is_too_fast(long long robot, const int *speeds)
{
    const double *most = arena + calm->most + AXES * robot;
    int axis;

    for (axis = 0; axis < AXES; axis++)
        if (__builtin_fabs(speeds[axis]) > most[axis])
            return 1;
    return 0;
}

/* Answer the requests with a code that arrive in this cycle; return RUN when that is done. */
static int serve(int code)
{
    static long long some[MOST];
    static double clocks[MOST], joined[MOST], to[MOST];
    static int values[MOST * INTEGERS];
    static struct reply told[MOST];
    struct service service = { calm->end, nextafter(calm->end, 0), command_of(code), calm->cycle };
    int i, k, count = 0, found;

    if (service.command < 0)
        return REFUSED;
    for (i = 0; i < calm->count; i++) {
        const struct record *each = &records[i];

        if (each->code != code || !(each->due < calm->end))
            continue;
        if (service.command == CRS_VM && is_too_fast(i, each->message.i))
            return REFUSED;
        some[count] = i;
        clocks[count] = each->due;
        joined[count] = arena[calm->joined + i];
        for (k = 0; k < INTEGERS; k++)
            values[INTEGERS * count + k] = each->message.i[k];
        count++;
    }
    found = __crs_serve(count, some, &service, clocks, joined, values, tables, told);
    if (found == SENSOR_DUE) {
        for (i = 0; i < count; i++)
            to[i] = at_most(clocks[i], service.last);
        found = fire(count, some, to);
        if (found != RUN)
            return found;
        found = __crs_serve(count, some, &service, clocks, joined, values, tables, told);
    }
    if (found != ADVANCED)
        return REFUSED;
    calm->batch++;
    calm->served += count;
    for (i = 0; i < count; i++)
        reply(some[i], code, clocks[i], &told[i]);
    return RUN;
}

/* Answer all requests that arrive in this cycle, by rising codes; return RUN when that is done. */
static int serve_all(void)
{
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
        found = serve(code);
        if (found != RUN)
            return found;
    }
}

/* -- the end of a cycle ------------------------------------------------------------------------- */

static double nearest_side(double x, double y, double most)
{
    const double *segment = arena + calm->segments;
    int i;

    for (i = 0; i < calm->segment_count; i++, segment += SEGMENT_SIZE) {
        double across_x = x - segment[2], across_y = y - segment[3];
        double along_x = segment[4] - segment[2], along_y = segment[5] - segment[3];
        double length2 = along_x * along_x + along_y * along_y;
        double share = (across_x * along_x + across_y * along_y) / (length2 > 0 ? length2 : 1);

        share = at_most(at_least(share, 0), 1);
        across_x -= share * along_x;
        across_y -= share * along_y;
        most = at_most(most, __builtin_sqrt(across_x * across_x + across_y * across_y));
    }
    return most;
}

static double nearest_circle(double x, double y, int own, double most)
{
    const double *circle = arena + calm->circles;
    int i;

    for (i = 0; i < calm->circle_count; i++, circle += CIRCLE_SIZE) {
        double off_x = x - circle[2], off_y = y - circle[3];

        if (i != own)
            most = at_most(most, __builtin_sqrt(off_x * off_x + off_y * off_y) - circle[4]);
    }
    return most;
}

/* Return the shortest distance between a robot and anything else, see `geometry/clearance.py`. */
static double clearance(void)
{
    const double *circle = arena + calm->circles;
    double most = INFINITY;
    int i;

    for (i = 0; i < calm->circle_count; i++, circle += CIRCLE_SIZE) {
        double x = circle[2], y = circle[3];

        if (circle[1] < calm->count)
            most = at_most(most, nearest_circle(x, y, i, nearest_side(x, y, INFINITY)) - circle[4]);
    }
    return most;
}

/* Return whether robots have room for this cycle, which is reserved, and change no goal in it. */
static int has_room(void)
{
    double way = 0, need, room = calm->room;
    int i;

    for (i = 0; i < calm->count; i++) {
        const double *moved = tables->robots[i].moved;

        way = at_least(way, __builtin_fabs(moved[0]) + __builtin_fabs(moved[1]));
    }
    if (!(calm->goal_room >= 2 * way))
        return 0;
    need = 2 * way + calm->slop;
    if (room < need)
        room = clearance();
    room -= need;
    if (!(room >= 0))
        return 0;
    calm->room = room;
    calm->goal_room -= 2 * way;
    return 1;
}

static int moves(void)
{
    int i, axis;

    for (i = 0; i < calm->count; i++)
        for (axis = 0; axis < AXES; axis++)
            if (tables->robots[i].slice[axis] != 0)
                return 1;
    return 0;
}

static void copy(double *to, const double *from, long long count)
{
    for (; count > 0; count--)
        *to++ = *from++;
}

/* Exchange what `finish` changes with its copy. */
static void keep(int restores)
{
    void *parts[] = { tables->robots, tables->bodies, tables->batteries };
    const long long sizes[] = { sizeof *tables->robots, sizeof *tables->bodies,
        sizeof *tables->batteries };
    double *kept = arena + calm->backup;
    int i;

    for (i = 0; i < 3; i++) {
        long long count = sizes[i] / 8 * calm->count;

        if (restores)
            copy(parts[i], kept, count);
        else
            copy(kept, parts[i], count);
        kept += count;
    }
}

/* Move bodies, as nothing is near; return whether that is all. */
static int finish(void)
{
    static double before[2 * MOST];
    static int empty[2 + MOST];
    struct cycle cycle = { calm->timestep, calm->end, 1, -1 };
    double room = calm->room, goal_room = calm->goal_room;

    keep(0);
    if (has_room()
        && __crs_finish((int)calm->count, &cycle, arena + calm->joined, before, tables, empty)
            == ADVANCED
        && empty[0] == 0) {
        calm->is_weary = empty[1];
        return 1;
    }
    keep(1);
    calm->room = room;
    calm->goal_room = goal_room;
    return 0;
}

/* Log where robots are, and place their outlines there. */
static void show(void)
{
    struct frame *frame = (struct frame *)(arena + calm->frames) + calm->ended * calm->count;
    double *circle = arena + calm->circles;
    int i;

    for (i = 0; i < calm->circle_count; i++, circle += CIRCLE_SIZE)
        if (circle[1] < calm->count) {
            circle[2] = tables->bodies[(int)circle[1]].x;
            circle[3] = tables->bodies[(int)circle[1]].y;
        }
    for (i = 0; i < (calm->frame_room ? calm->count : 0); i++, frame++) {
        const struct robot *robot = &tables->robots[i];
        const struct odometry *odometry = &robot->odometry;

        frame->x = tables->bodies[i].x;
        frame->y = tables->bodies[i].y;
        frame->heading = robot->heading;
        frame->turret = robot->turret;
        frame->believed[0] = odometry->x;
        frame->believed[1] = odometry->y;
        frame->believed[2] = odometry->heading;
    }
}

/* End the cycle that programs have used up; return RUN, or what prevents it. */
static int end_cycle(void)
{
    static double to[MOST];
    double last = nextafter(calm->end, 0);
    int i, count = (int)calm->present, found, stands;

    for (i = 0; i < count; i++)
        to[i] = calm->end;
    found = __crs_advance(count, 0, rows, last, to, tables);
    if (found == SENSOR_DUE) {
        for (i = 0; i < count; i++)
            to[i] = last;
        found = fire(count, rows, to);
        if (found != RUN)
            return found;
        for (i = 0; i < count; i++)
            to[i] = calm->end;
        found = __crs_advance(count, 0, rows, last, to, tables);
    }
    if (found != ADVANCED)
        return REFUSED;
    stands = !moves() && !calm->served;
    if (!finish())
        return REFUSED;
    show();
    calm->cycle++;
    calm->ended++;
    calm->end = end_of(calm->cycle);
    calm->rounds = 0;
    calm->was_served = calm->served;
    calm->served = 0;
    if (!calm->keeps)
        calm->answer_count = 0;
    if (calm->cycle >= calm->until || !is_anybody_alive())
        return DONE;
    return calm->is_weary ? REFUSED : stands ? STANDS : RUN;
}

/* Go on after programs have run; return why. */
static int go_on(void)
{
    int found;

    if (calm->ran > 0)
        calm->rounds += calm->ran;
    if (!send())
        return ASKED;
    for (;;) {
        found = serve_all();
        if (found != RUN)
            return found;
        if (can_run())
            return RUN;
        if (calm->cycle >= calm->until)
            return DONE;                /* the cycle, which is used up, is not to be ended */
        if (calm->frame_room && (calm->ended + 1) * calm->count > calm->frame_room)
            return FULL;
        found = end_cycle();
        if (found != RUN)
            return found;
    }
}

void __crs_calm(double *memory, const struct tables *all)
{
    calm = (struct calm *)memory;
    arena = memory;
    tables = all;
    records = (struct record *)(arena + calm->records);
    rows = (const long long *)(arena + calm->rows);
    calm->end = end_of(calm->cycle);
    calm->verdict = go_on();
}
