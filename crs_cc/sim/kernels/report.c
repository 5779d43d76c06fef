/* What `State` says of a robot's motion, see `devices/vendor_state.py`. */
#include <math.h>

#include "kernels.h"
#include "robot.h"

#define TENTH_INCH (0.0254 / 10)        /* [m] */
#define TENTH_DEGREE (M_PI / 1800)      /* [rad] */
#define FULL_TURN 3600
#define LARGEST 2147483647

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

/* Each report is position, angles and speeds, and a bit for each motor that works. */
void __crs_reports(int count, const long long *rows, const struct drive *drives,
                   const struct robot *robots, int *out)
{
    int i, axis;

    for (i = 0; i < count; i++, out += 8) {
        int row = rows ? rows[i] : i;
        const struct robot *robot = &robots[row];
        const struct axes *a = &robot->axes;
        const double *unit = drives[row].unit;

        out[0] = whole(robot->odometry.x / TENTH_INCH);
        out[1] = whole(robot->odometry.y / TENTH_INCH);
        out[2] = angle(robot->odometry.heading);
        out[3] = angle(robot->odometry.turret);
        out[7] = 0;
        for (axis = 0; axis < AXES; axis++) {
            double end = a->start[axis] + a->ramp_time[axis];

            end = end + a->cruise_time[axis] + a->brake_time[axis];
            out[4 + axis] = unit[axis] > 0 ? whole(a->speed[axis] / unit[axis]) : 0;
            if (end > robot->clock && !robot->limp[axis])
                out[7] |= 1 << axis;
        }
    }
}
