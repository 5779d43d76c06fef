/*
 * nomad.c - the driver of Nomad robots: fills the server's interfaces from State.
 *
 * Written in the style of device servers of about 2005 around an old client: functions
 * without prototypes, all groups of State read in each cycle, a hand-written mask of the
 * data in replies, and the usual way to switch off the sonars, an order with one element,
 * 255.
 *
 * Drivers of the time wrote the mask in a loop to i <= NUM_MASK, one past its end. crs
 * stops this with an error, unless checks are off (--unchecked); so here it is <.
 */

# include <stdio.h>
# include <string.h>
# include <math.h>
# include "Nclient.h"
# include "driver.h"

# define INCH           0.0254
# define TENTH          (INCH / 10.0)
# define TENTH_DEGREE   (M_PI / 1800.0)
# define RATE           15
# define SHELL_BUMPERS  8

static int order[MAX_RANGES] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };
static int off[1] = { 255 };
static double wheel_base = 2.0 * ROTATION_CONSTANT / TENTH_DEGREE * TENTH;

/* Replies contain everything except infrared ring and laser, which a Scout lacks. */
static
write_mask(ir, laser)
{
    int i;

    for (i = 0; i < NUM_MASK; i++)
        Smask[i] = 1;
    Smask[SMASK_POS_DATA] = 0;
    for (i = SMASK_IR_1; i <= SMASK_IR_16; i++)
        Smask[i] = ir;
    Smask[SMASK_LASER] = laser;
    ct();
}

static
nomad_setup(d, argc, argv)
    driver *d;
    char **argv;
{
    char *device = argc > 1 ? argv[1] : "/dev/ttyS0";

    if (connect_robot(1, MODEL_SCOUT2, device, 38400) == FALSE)
        return -1;
    write_mask(0, 0);
    conf_tm(2);
    conf_sn(RATE, order);
    ac(150, 150, 0);
    sp(100, 100, 0);
    zr();
    ws(1, 1, 1, 0);
    dp(0, 0);
    da(0, 0);
    d->sonar.count = SONARS;
    d->ir.count = 0;
    d->bumper.count = SHELL_BUMPERS;
    return 0;
}

static
nomad_shutdown(d)
    driver *d;
{
    st();
    conf_sn(RATE, off);
    return disconnect_robot(1) ? 0 : -1;
}

static
read_position(p)
    register position_data *p;
{
    double right = State[STATE_VEL_RIGHT] * TENTH, left = State[STATE_VEL_LEFT] * TENTH;

    p->px = State[STATE_CONF_X] * TENTH;
    p->py = State[STATE_CONF_Y] * TENTH;
    p->pa = remainder(State[STATE_CONF_STEER] * TENTH_DEGREE, 2.0 * M_PI);
    p->vx = (right + left) / 2.0;
    p->va = (right - left) / wheel_base;
    p->stall = State[STATE_BUMPER] != 0 && (State[STATE_MOTOR_STATUS] & 3) != 0;
}

/* Sonars: whole inches, 255 for no echo. Infrared: 0 to 15, about inches, 15 for none. */
static
read_rangers(d)
    driver *d;
{
    int i;

    for (i = 0; i < d->sonar.count; i++)
        d->sonar.ranges[i] = State[STATE_SONAR_0 + i] * INCH;
    for (i = 0; i < d->ir.count; i++)
        d->ir.ranges[i] = State[STATE_IR_0 + i] * INCH;
}

static
nomad_update(d)
    driver *d;
{
    int i;

    d->updates++;
    if (!gs() || State[STATE_ERROR] != 0) {
        d->failures++;
        return -1;
    }
    read_position(&d->position);
    read_rangers(d);
    for (i = 0; i < d->bumper.count; i++)
        d->bumper.bumpers[i] = State[STATE_BUMPER] >> i & 1;
    d->power.volts = voltMotorGet();
    return 0;
}

/* Speeds are floating-point; arguments of vm() must be int, nothing converts them. */
static
nomad_command(d, vx, va)
    driver *d;
    double vx, va;
{
    int right = (int) rint((vx + va * wheel_base / 2.0) / TENTH);
    int left = (int) rint((vx - va * wheel_base / 2.0) / TENTH);

    return mv(MV_VM, right, MV_VM, left, MV_IGNORE, 0) ? 0 : -1;
}

driver nomad_driver = { "nomad", nomad_setup, nomad_shutdown, nomad_update, nomad_command };
