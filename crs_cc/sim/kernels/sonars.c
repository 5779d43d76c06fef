/* The firing of sonars of robots that move as their wheels do, see `devices/sonar`. */
#include <math.h>

#include "echoes.h"
#include "kernels.h"
#include "robot.h"

#define SOUND 343.2                     /* [m/s], as in `core/units.py` */
#define NONE (-1)                       /* no ping is in the air */

/* Errors of a sonar, see `devices/sonar/errors.py`. */
struct errors {
    double blind, minimum, noise, share, misses, resolution;
};

/* A row for each sonar of each mode of a kind of robot. */
struct beam {
    struct point mount, direction;
    double half, range, falloff, critical;
    struct errors errors;
};

/* Rows of shapes, see rays.c. */
struct segment {
    double viewer, object;
    struct point start, end;
    double length;
};

struct circle {
    double viewer, object;
    struct point middle;
    double radius;
};

/* The range that is reported for a true distance, infinite for no echo. */
static double reported(const struct errors *errors, double distance, const double *deviates)
{
    double error, share;

    if (distance < errors->blind)
        distance = distance > 0 ? ceil(errors->blind / distance) * distance : errors->blind;
    distance = distance < errors->minimum ? errors->minimum : distance;
    if (distance == INFINITY || deviates[1] < errors->misses)
        return INFINITY;
    share = errors->share * distance;
    error = deviates[0] * __builtin_sqrt(errors->noise * errors->noise + share * share);
    distance = distance + error > 0 ? distance + error : 0;
    if (errors->resolution > 0)
        return rint(distance / errors->resolution) * errors->resolution;
    return distance;
}

/* Columns: distances, errors, and deviates. */
void __crs_errors(int count, double *columns)
{
    const struct errors *errors = (const struct errors *)(columns + count);
    const double *deviates = (const double *)(errors + count);
    int i;

    for (i = 0; i < count; i++)
        columns[i] = reported(&errors[i], columns[i], deviates + DEVIATES * i);
}

/* Record the echo that a robot waits for, or that there is none, if the time has come. */
static void hear(struct robot *robot, struct sonars *sonars, double to)
{
    int which = (int)robot->listening, i;

    if (which == NONE || robot->hears > to)
        return;
    robot->echo[which] = sonars->heard;
    sonars->fired[which] = sonars->sent;
    for (i = 0; i < CONFIGURATION; i++)
        sonars->fired_from[which][i] = sonars->sent_from[i];
    robot->listening = NONE;
}

static struct point product(const struct point *a, const struct point *b)
{
    struct point result = { a->x * b->x - a->y * b->y, a->x * b->y + a->y * b->x };

    return result;
}

double __crs_mount(const struct robot *robot, const struct constants *constants)
{
    double base = constants->is_synchro != 0 ? robot->base : robot->facing;

    return constants->has_turret != 0 ? robot->turret : base;
}

/* Return the ping of a sonar from where its robot has come in this cycle. */
static struct ping ping_of(const struct beam *beam, const struct robot *robot,
                           const struct body *body, const struct constants *constants)
{
    double angle = __crs_mount(robot, constants);
    struct point turn, offset;
    struct ping ping;

    __crs_sin_cos(angle, &turn.y, &turn.x);
    offset = product(&beam->mount, &turn);
    ping.place.x = body->x + robot->moved[0];
    ping.place.y = body->y + robot->moved[1];
    ping.start.x = ping.place.x + offset.x;
    ping.start.y = ping.place.y + offset.y;
    ping.axis = product(&beam->direction, &turn);
    ping.half = beam->half;
    ping.range = beam->range;
    ping.falloff = beam->falloff;
    ping.critical = beam->critical;
    ping.crosstalk = 0;
    return ping;
}

/* Return the distance of a ping's first echo: from anything but the robot itself. */
static double first_echo(struct ping *ping, long long own, const struct surroundings *around)
{
    const struct segment *segments = (const struct segment *)around->segments;
    const struct circle *circles = (const struct circle *)around->circles;
    struct face *faces = (struct face *)around->work, *face = faces;
    struct round *rounds = (struct round *)(faces + around->segment_count), *round = rounds;
    double found;
    int i;

    for (i = 0; i < around->segment_count; i++, face++) {
        face->start = segments[i].start;
        face->along = segments[i].end;
        face->away = segments[i].length;
        face->share = 1;
    }
    for (i = 0; i < around->circle_count; i++) {
        if (circles[i].object == own)
            continue;
        round->middle = circles[i].middle;
        round->radius = circles[i].radius;
        round->share = 1;
        round++;
    }
    ping->faces = around->segment_count;
    ping->rounds = (double)(round - rounds);
    __crs_echoes(1, 0, (double *)ping, (double *)faces, (double *)rounds, 0, &found);
    return found;
}

/* Send the ping of a robot that is due. */
static void fire(long long row, double mode, const double *deviates,
                 const struct surroundings *around, const struct tables *tables)
{
    struct robot *robot = &tables->robots[row];
    struct sonars *sonars = &tables->sonars[row];
    const struct constants *constants = &tables->kinds[(int)robot->kind];
    long long number = sonars->order[sonars->turn % sonars->length];
    const struct beam *beam = (const struct beam *)around->beams
        + ((long long)mode + sonars->mode) * SONARS + number;
    double at = robot->fires, lasts = 2 * beam->range / SOUND, distance, takes;
    struct ping ping;
    int configuration[CONFIGURATION + 1], i;

    __crs_move(robot, constants, at > robot->clock ? at : robot->clock);
    hear(robot, sonars, at);
    ping = ping_of(beam, robot, &tables->bodies[row], constants);
    distance = reported(&beam->errors, first_echo(&ping, row, around), deviates);
    takes = 2 * distance / SOUND;
    lasts = lasts < sonars->interval ? lasts : sonars->interval;
    sonars->heard = takes <= lasts ? distance : INFINITY;
    robot->hears = at + (takes <= lasts ? takes : lasts);
    robot->listening = number;
    sonars->sent = at;
    __crs_report(robot, constants, configuration);
    for (i = 0; i < CONFIGURATION; i++)
        sonars->sent_from[i] = configuration[i];
    sonars->count++;
    sonars->turn++;
    robot->fires = sonars->start + sonars->turn * sonars->interval;
}

int __crs_fire(int count, const long long *rows, const double *to,
               const struct surroundings *around, const struct tables *tables)
{
    int i, is_due = 0;

    for (i = 0; i < count; i++) {
        const struct robot *robot = &tables->robots[rows ? rows[i] : i];

        if (robot->fires <= to[i]
            && (robot->hindered || robot->slipping || robot->deadline < to[i]))
            return NOT_HANDLED;
    }
    for (i = 0; i < count; i++) {
        long long row = rows ? rows[i] : i;
        struct robot *robot = &tables->robots[row];

        if (robot->fires <= to[i])
            fire(row, around->modes[i], around->deviates + DEVIATES * i, around, tables);
        if (robot->fires <= to[i])
            is_due = 1;
        else
            hear(robot, &tables->sonars[row], to[i]);
    }
    return is_due ? SENSOR_DUE : ADVANCED;
}
