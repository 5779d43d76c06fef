/* What `State` says of a robot's motion, see `devices/vendor_state.py`. */
#include <math.h>

#include "kernels.h"

#define AXES 3
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

/* Columns: x, y, heading, turret, time of each robot; start and durations of ramp, cruise and
   braking, speed and unit of each axis; whether it is limp, in bytes. Each report is position,
   angles and speeds, and a bit for each motor that works. */
void __crs_reports(int count, const double *columns, int *out)
{
    const double *x = columns, *y = x + count, *heading = y + count, *turret = heading + count;
    const double *time = turret + count, *start = time + count, *ramp = start + AXES * count;
    const double *cruise = ramp + AXES * count, *brake = cruise + AXES * count;
    const double *speed = brake + AXES * count, *unit = speed + AXES * count;
    const unsigned char *limp = (const unsigned char *)(unit + AXES * count);
    int i, axis, place = 0;

    for (i = 0; i < count; i++, out += 8) {
        out[0] = whole(x[i] / TENTH_INCH);
        out[1] = whole(y[i] / TENTH_INCH);
        out[2] = angle(heading[i]);
        out[3] = angle(turret[i]);
        out[7] = 0;
        for (axis = 0; axis < AXES; axis++, place++) {
            double end = start[place] + ramp[place] + cruise[place] + brake[place];

            out[4 + axis] = unit[place] > 0 ? whole(speed[place] / unit[place]) : 0;
            if (end > time[i] && !limp[place])
                out[7] |= 1 << axis;
        }
    }
}
