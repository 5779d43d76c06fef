/* Requests that need nothing but the rows of robots: those for `State`, and speeds of axes. */
#include <crs_request.h>

#include "kernels.h"
#include "robot.h"

/* Return whether a robot can answer such a request by itself. */
static int is_simple(const struct robot *robot, int sets_speeds)
{
    const unsigned char *limp = robot->limp;

    return robot->connected && !(sets_speeds && (limp[0] || limp[1] || limp[2]));
}

/* Run `vm` or `st`, for which the robot has been advanced. */
static void run(long long row, const struct service *service, const int *values,
                const struct tables *tables)
{
    struct robot *robot = &tables->robots[row];
    const struct drive *drive = &tables->kinds[(int)robot->kind].drive;
    double speeds[AXES];
    int axis;

    for (axis = 0; axis < AXES; axis++)
        speeds[axis] = service->command == CRS_ST ? 0 : values[axis] * drive->unit[axis];
    __crs_speeds(1, &row, speeds, 0, 0, tables);
    robot->command = (long long)service->command;
    robot->command_cycle = (long long)service->cycle;
}

/* Tell where mounts are, as `devices/mount.py`: what has slipped counts as being where it was. */
static void tell_mounts(int count, const long long *rows, const struct tables *tables, double *out)
{
    int i;

    for (i = 0; i < count; i++, out += 3) {
        long long row = rows ? rows[i] : i;
        const struct robot *robot = &tables->robots[row];
        const struct body *body = &tables->bodies[row];

        out[0] = body->x + (robot->slipping ? 0 : robot->moved[0]);
        out[1] = body->y + (robot->slipping ? 0 : robot->moved[1]);
        out[2] = __crs_mount(robot, &tables->kinds[(int)robot->kind]);
    }
}

int __crs_serve(int count, const long long *rows, const struct service *service, double *clocks,
                double *joined, int *values, const struct tables *tables, struct reply *out)
{
    int i, found, sets_speeds = service->command != 0;

    for (i = 0; i < count; i++) {
        const struct robot *robot = &tables->robots[rows ? rows[i] : i];

        if (!is_simple(robot, sets_speeds))
            return NOT_HANDLED;
        clocks[i] = clocks[i] > robot->clock ? clocks[i] : robot->clock;
        clocks[i] = clocks[i] < service->end ? clocks[i] : service->end;
    }
    found = __crs_advance(count, 1, rows, service->last, clocks, tables);
    if (found != ADVANCED)
        return found;
    for (i = 0; i < count; i++) {
        long long row = rows ? rows[i] : i;

        tables->robots[row].requests++;
        if (sets_speeds)
            run(row, service, values + INTEGERS * i, tables);
        joined[i] = clocks[i] - joined[i];
    }
    __crs_replies(count, rows, joined, tables, out);
    tell_mounts(count, rows, tables, (double *)values);
    return ADVANCED;
}
