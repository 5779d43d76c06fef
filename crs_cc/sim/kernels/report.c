/* What the reply to a request tells of a robot: `State`, see `devices/vendor_state.py`, the charge of
   its batteries, see `devices/battery`, and the time of its board, see `devices/clock`. */
#include <math.h>

#include "kernels.h"
#include "robot.h"

#define INCH 0.0254                     /* [m] */
#define TENTH_INCH (INCH / 10)
#define TENTH_DEGREE (M_PI / 1800)      /* [rad] */
#define FULL_TURN 3600
#define LARGEST 2147483647
#define NO_ECHO 255                     /* [in] */
#define REAL_TIME 10
#define ROUNDING 1e-9                   /* [ticks] */
#define WRAP 4294967296.0               /* [ms] */

/* Places in `State`. */
enum { SIM_SPEED, IR_0, SONAR_0 = 17, BUMPER = SONAR_0 + SONARS, CONF_X };

static int whole(double value)
{
    value = rint(value);
    return value > LARGEST ? LARGEST : value < -LARGEST ? -LARGEST : (int)value;
}

static int angle(double value)
{
    int tenths = whole(value / TENTH_DEGREE) % FULL_TURN;

    return tenths < 0 ? tenths + FULL_TURN : tenths;
}

static int inches(double value)
{
    value = rint(value / INCH);
    return value < NO_ECHO ? value > 0 ? (int)value : 0 : NO_ECHO;
}

/* The speeds of axes, as their encoders measure them. */
static void speeds(const struct robot *robot, const struct constants *constants, double *out)
{
    const double *driven = robot->axes.speed, *forward = constants->drive.forward;
    double lag = 0;

    if (robot->hindered) {
        lag = driven[0] * forward[0] + driven[1] * forward[1] + driven[2] * forward[2];
        lag -= robot->forward;
    }
    __crs_lag(constants, lag, driven, out);
}

/* Position, angles and speeds, and a bit for each motor that works. */
void __crs_report(const struct robot *robot, const struct constants *constants, int *out)
{
    const struct axes *a = &robot->axes;
    const double *unit = constants->drive.unit;
    double speed[AXES];
    int axis;

    speeds(robot, constants, speed);

    out[0] = whole(robot->odometry.x / TENTH_INCH);
    out[1] = whole(robot->odometry.y / TENTH_INCH);
    out[2] = angle(robot->odometry.heading);
    out[3] = angle(robot->odometry.turret);
    out[7] = 0;
    for (axis = 0; axis < AXES; axis++) {
        double end = a->start[axis] + a->ramp_time[axis];

        end = end + a->cruise_time[axis] + a->brake_time[axis];
        out[4 + axis] = unit[axis] > 0 ? whole(speed[axis] / unit[axis]) : 0;
        if (end > robot->clock && !robot->limp[axis])
            out[7] |= 1 << axis;
    }
}

/* The charge of a motor's or computer's battery after some time in the world. */
static double charge(const struct supply *supply, int which, double time, double moved)
{
    double left = supply->start[which]
        - (supply->power[which] * time + moved) / supply->capacity[which];

    return left < 0 ? 0 : left;
}

static double motor_charge(const struct robot *robot, double time, const struct tables *tables)
{
    const struct supply *supply = &tables->kinds[(int)robot->kind].supply;

    return charge(supply, 1, time,
                  robot->battery < 0 ? 0 : tables->batteries[(int)robot->battery].used);
}

static void charges(const struct robot *robot, double time, const struct tables *tables,
                    double *out)
{
    out[0] = charge(&tables->kinds[(int)robot->kind].supply, 0, time, 0);
    out[1] = motor_charge(robot, time, tables);
}

int __crs_is_empty(const struct robot *robot, double time, const struct tables *tables)
{
    return motor_charge(robot, time, tables) < tables->kinds[(int)robot->kind].supply.least;
}

void __crs_charges(int count, const long long *rows, const double *times,
                   const struct tables *tables, double *out)
{
    int i;

    for (i = 0; i < count; i++)
        charges(&tables->robots[rows ? rows[i] : i], times[i], tables, out + 2 * i);
}

void __crs_reports(int count, const long long *rows, const struct tables *tables, int *out)
{
    int i;

    for (i = 0; i < count; i++) {
        const struct robot *robot = &tables->robots[rows ? rows[i] : i];

        __crs_report(robot, &tables->kinds[(int)robot->kind], out + 8 * i);
    }
}

static void state(const struct robot *robot, const struct constants *constants, int *out)
{
    int i;

    for (i = 0; i < NUM_STATE; i++)
        out[i] = 0;
    out[SIM_SPEED] = REAL_TIME;
    for (i = 0; i < SONARS; i++)
        out[SONAR_0 + i] = inches(robot->echo[i]);
    out[BUMPER] = robot->pressed;
    __crs_report(robot, constants, &out[CONF_X]);
}

double __crs_board_ms(double time, double tick)
{
    double ticks = floor(time / tick + ROUNDING);

    return fmod(floor(ticks * tick * 1e3 + ROUNDING), WRAP);
}

void __crs_replies(int count, const long long *rows, const double *times,
                   const struct tables *tables, struct reply *out)
{
    int i;

    for (i = 0; i < count; i++, out++) {
        const struct robot *robot = &tables->robots[rows ? rows[i] : i];
        const struct constants *own = &tables->kinds[(int)robot->kind];

        state(robot, own, out->state);
        charges(robot, times[i], tables, out->charge);
        out->ms = __crs_board_ms(own->clock_start + times[i], own->clock_tick);
    }
}
