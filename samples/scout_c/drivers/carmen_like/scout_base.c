/*
 * scout_base.c - a Scout as a base: between metres and tenths of an inch.
 *
 * Written in the style of toolkits of about 2000. They wrap each call of the client, pass
 * floating-point numbers where it expects integers, relying on the header to convert
 * them, and switch the sonars off by passing no order.
 */

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/time.h>
#include "Nclient.h"
#include "base_direct.h"

#define METRES_PER_INCH   0.0254
#define METRES_PER_SCOUT  (METRES_PER_INCH / 10.0)
#define DEGREES_PER_SCOUT 0.1
#define MAXV              (1.0 / METRES_PER_SCOUT)
#define MAX_SONARS        16
#define WHEELBASE         (2.0 * ROTATION_CONSTANT * 180.0 / M_PI * METRES_PER_INCH)
#define MIN_POLL          0.06      /* polling faster only loads the line, seconds */

static int sonar_is_on = 0;
static int model_type;
static double time_since_last_command = 0;

double get_time(void)
{
    struct timeval t;

    gettimeofday(&t, NULL);
    return t.tv_sec + t.tv_usec / 1e6;
}

static double normalize_theta(double theta)
{
    while (theta > M_PI)
        theta -= 2.0 * M_PI;
    while (theta < -M_PI)
        theta += 2.0 * M_PI;
    return theta;
}

static double scout_theta(void)
{
    double degrees = (double) State[STATE_CONF_STEER] * DEGREES_PER_SCOUT;

    return normalize_theta(degrees * M_PI / 180.0);
}

/* Every call sends a packet, and each reply updates State. */
static int sent(int result)
{
    time_since_last_command = get_time();
    return result == FALSE ? -1 : 0;
}

int base_direct_initialize_robot(char *model, char *dev)
{
    static const struct { const char *name; int type; } models[] = {
        { "N200", MODEL_N200 }, { "N150", MODEL_N150 },
        { "SCOUT", MODEL_SCOUT }, { "SCOUT2", MODEL_SCOUT2 },
    };
    unsigned i;

    for (i = 0; i < sizeof models / sizeof models[0]; i++)
        if (strcasecmp(model, models[i].name) == 0) {
            model_type = models[i].type;
            return sent(connect_robot(1, model_type, dev, 38400));
        }
    return -1;
}

int base_direct_shutdown_robot(void)
{
    st();
    lp();
    return sent(disconnect_robot(1));
}

/* Resets the encoders at the current position. */
int base_direct_reset(void)
{
    return sent(zr());
}

int base_direct_sonar_on(void)
{
    int sn_order[MAX_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };

    sonar_is_on = 1;
    return sent(conf_sn(15, sn_order)) == -1 || sent(conf_tm(5)) == -1 ? -1 : 0;
}

int base_direct_sonar_off(void)
{
    sonar_is_on = 0;
    return sent(conf_sn(0, NULL));
}

int base_direct_set_acceleration(double acceleration)
{
    double acc = acceleration / METRES_PER_SCOUT;

    return sent(ac(acc, acc, 0.0));
}

/* The robot has one number for both. */
int base_direct_set_deceleration(double deceleration)
{
    return base_direct_set_acceleration(deceleration);
}

static double limited(double v)
{
    return v > MAXV ? MAXV : v < -MAXV ? -MAXV : v;
}

int base_direct_set_velocity(double tv, double rv)
{
    float vl, vr;

    if (model_type != MODEL_SCOUT)
        return sent(vm(tv / METRES_PER_SCOUT, rv * 180.0 / M_PI / DEGREES_PER_SCOUT, 0.0));
    vl = limited((tv - 0.5 * rv * WHEELBASE) / METRES_PER_SCOUT);
    vr = limited((tv + 0.5 * rv * WHEELBASE) / METRES_PER_SCOUT);
    return sent(vm(floorf(vr + 0.5f), floorf(vl + 0.5f), 0.0));
}

int base_direct_update_status(void)
{
    if (get_time() - time_since_last_command < MIN_POLL)
        return 0;
    return gs() ? 0 : -1;
}

/* Returns the changes since the last call. */
int base_direct_get_state(double *displacement, double *rotation, double *tv, double *rv)
{
    static int initialised = 0;
    static double prev_x, prev_y, prev_theta;
    double x = (double) State[STATE_CONF_X] * METRES_PER_SCOUT;
    double y = (double) State[STATE_CONF_Y] * METRES_PER_SCOUT;
    double theta = scout_theta();

    if (displacement)
        *displacement = initialised ? hypot(x - prev_x, y - prev_y) : 0.0;
    if (rotation)
        *rotation = initialised ? normalize_theta(theta - prev_theta) : 0.0;
    initialised = 1;
    prev_x = x;
    prev_y = y;
    prev_theta = theta;
    return base_direct_get_integrated_state(NULL, NULL, NULL, tv, rv);
}

int base_direct_get_integrated_state(double *x, double *y, double *theta, double *tv, double *rv)
{
    double right = (double) State[STATE_VEL_RIGHT] * METRES_PER_SCOUT;
    double left = (double) State[STATE_VEL_LEFT] * METRES_PER_SCOUT;

    if (x)
        *x = (double) State[STATE_CONF_X] * METRES_PER_SCOUT;
    if (y)
        *y = (double) State[STATE_CONF_Y] * METRES_PER_SCOUT;
    if (theta)
        *theta = scout_theta();
    if (tv)
        *tv = (right + left) / 2.0;
    if (rv)
        *rv = (right - left) / WHEELBASE;
    return 0;
}

int base_direct_get_sonars(double *ranges, int num_sonars)
{
    int i;

    if (ranges == NULL || !sonar_is_on)
        return -1;
    if (num_sonars > MAX_SONARS)
        num_sonars = MAX_SONARS;
    for (i = 0; i < num_sonars; i++)
        ranges[i] = (double) State[i + STATE_SONAR_0] * METRES_PER_INCH;
    return 0;
}

int base_direct_get_bumpers(unsigned char *state, int num_bumpers)
{
    int i;

    for (i = 0; i < num_bumpers; i++)
        state[i] = (State[STATE_BUMPER] >> i) & 1;
    return 0;
}

/* Returns all of State. */
int base_direct_get_binary_data(unsigned char **data, int *size)
{
    if (data == NULL || size == NULL)
        return -1;
    *size = NUM_STATE * sizeof(long);
    *data = (unsigned char *) calloc(NUM_STATE, sizeof(long));
    if (*data == NULL)
        return -1;
    memcpy(*data, State, *size);
    return 0;
}
