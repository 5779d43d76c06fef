/*
 * follow_wall.c - find a wall and follow it on the right.
 *
 * A state machine: each state is a function that evaluates the sonars, sets the wheels
 * and returns the next state.
 *
 *     seek     drive straight until something is ahead or at the right
 *     align    turn left in place until the wall lies at the right
 *     follow   keep DISTANCE with a PID controller on the distance to the wall
 *     corner   the wall ended: swing around its end to the right
 *     escape   a bumper closed: back off, then align
 *
 * Each change of state is printed with the pose, and a line every two seconds.
 *
 * Usage:  crs run follow_wall.c room.xml            90 s
 *         crs run follow_wall.c room.xml -- 30      30 s
 */

#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define DISTANCE   15.0    /* distance to keep from the wall, inches */
#define STOP       14.0    /* distance of a wall ahead to follow next, inches */
#define CLEAR      24.0    /* free distance ahead needed to continue */
#define LOST       32.0    /* no wall on the right within this: it ended */
#define LEAN       0.7     /* weight of the angle to the wall against the distance */
#define CRUISE     90      /* forward speed, 0.1 inch/s */
#define CALL       0.0145  /* time of a command at 38400 baud, seconds */
#define LOOKS      5       /* calls of gs() before each decision */
#define TICK       ((LOOKS + 1) * CALL)   /* time between two decisions, seconds */

typedef struct {
    double kp, ki, kd;     /* 0.1 degree/s per inch, per inch second, per inch/s */
    double limit;          /* largest output, 0.1 degree/s */
    double sum, last;
    int started;
} Pid;

typedef struct {
    double ahead;          /* nearest echo ahead, inches */
    double side;           /* distance to the wall on the right, inches */
    double bow;            /* echo of the sonar between the two */
    double lean;           /* positive: the wall approaches ahead, inches */
    double heading;        /* degrees */
    int bumped;
} Senses;

typedef struct robot Robot;
typedef struct mode Mode;

struct mode {
    const char *name;
    const Mode *(*step)(Robot *robot);
};

struct robot {
    Senses now;
    Pid pid;
    const Mode *mode;
    int ticks;             /* since the state was entered */
    int total;             /* since the start */
    int trans, steer;      /* last command, 0.1 inch/s and 0.1 degree/s */
};

static const Mode *seek(Robot *), *align(Robot *), *follow(Robot *);
static const Mode *corner(Robot *), *escape(Robot *);

static const Mode SEEK = { "seek", seek };
static const Mode ALIGN = { "align", align };
static const Mode FOLLOW = { .name = "follow", .step = follow };
static const Mode CORNER = { .step = corner, .name = "corner" };
static const Mode ESCAPE = { "escape", escape };

/* Only the front and right sonars are fired: 7 x 40 ms instead of 16 x 60 ms. */
static int order[16] = { 0, 12, 15, 13, 1, 11, 14, 255 };

static double clip(double value, double limit)
{
    return value > limit ? limit : value < -limit ? -limit : value;
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double pid_output(Pid *pid, double error)
{
    double slope = pid->started ? (error - pid->last) / TICK : 0.0;

    pid->started = 1;
    pid->last = error;
    pid->sum = clip(pid->sum + error * TICK, 20.0);
    return clip(pid->kp * error + pid->ki * pid->sum + pid->kd * slope, pid->limit);
}

static void pid_reset(Pid *pid)
{
    pid->sum = pid->last = 0.0;
    pid->started = 0;
}

static double sonar(int number)
{
    return (double) State[STATE_SONAR_0 + number];
}

static Senses sense(void)
{
    Senses s;
    int call;

    for (call = 0; call < LOOKS; call++)
        gs();
    s.ahead = least(sonar(0), least(sonar(1), sonar(15)));
    s.side = least(sonar(12), least(sonar(11), sonar(13)));
    s.bow = sonar(14);
    s.lean = clip(sonar(11) - sonar(13), 12.0);
    s.heading = State[STATE_CONF_STEER] / 10.0;
    s.bumped = State[STATE_BUMPER] != 0;
    return s;
}

static void drive(Robot *robot, int trans, int steer)
{
    robot->trans = trans;
    robot->steer = steer;
    scout_vm(trans, steer);
}

static const Mode *seek(Robot *robot)
{
    if (robot->now.ahead < STOP)
        return &ALIGN;
    if (robot->now.side < DISTANCE + 3.0)
        return &FOLLOW;
    drive(robot, robot->now.ahead < 2.0 * STOP ? CRUISE / 2 : CRUISE, 0);
    return &SEEK;
}

static const Mode *align(Robot *robot)
{
    if (robot->now.ahead > CLEAR && robot->now.bow > DISTANCE && robot->now.side < LOST)
        return &FOLLOW;
    if (robot->ticks > 140)          /* nothing on the right in a full turn */
        return &SEEK;
    drive(robot, 0, 300);
    return &ALIGN;
}

static const Mode *follow(Robot *robot)
{
    double error = DISTANCE - robot->now.side;   /* positive: too near, turn left */
    double steer;

    if (robot->now.ahead < STOP)
        return &ALIGN;
    if (robot->now.side > LOST)
        return &CORNER;
    error += LEAN * robot->now.lean;             /* and along the wall */
    if (robot->now.bow < DISTANCE)               /* it bends in ahead of us */
        error += 0.5 * (DISTANCE - robot->now.bow);
    steer = pid_output(&robot->pid, error);
    drive(robot, (int) (CRUISE - 0.15 * fabs(steer)), (int) steer);
    return &FOLLOW;
}

static const Mode *corner(Robot *robot)
{
    if (robot->now.ahead < STOP)
        return &ALIGN;
    if (robot->ticks < 8) {                      /* first clear the edge */
        drive(robot, CRUISE / 2, 0);
        return &CORNER;
    }
    if (robot->now.side < DISTANCE + 4.0)
        return &FOLLOW;
    if (robot->ticks > 100)                      /* full circle: it was a table leg */
        return &SEEK;
    drive(robot, CRUISE / 2, -130);
    return &CORNER;
}

static const Mode *escape(Robot *robot)
{
    if (robot->ticks > 15)
        return &ALIGN;
    drive(robot, -CRUISE / 2, 0);
    return &ESCAPE;
}

static void report(const Robot *robot)
{
    printf("%6.1f s  %-7s x %6.1f y %6.1f heading %5.1f  side %5.1f ahead %5.1f  vm %3d %4d\n",
           robot->total * TICK, robot->mode->name, State[STATE_CONF_X] / 10.0,
           State[STATE_CONF_Y] / 10.0, robot->now.heading, robot->now.side, robot->now.ahead,
           robot->trans, robot->steer);
}

static void run(Robot *robot, int ticks)
{
    const Mode *next;

    while (robot->total++ < ticks) {
        robot->now = sense();
        next = robot->mode->step(robot);
        if (robot->now.bumped && robot->mode != &ESCAPE)
            next = &ESCAPE;
        if (next != robot->mode) {
            robot->mode = next;
            robot->ticks = 0;
            pid_reset(&robot->pid);
            report(robot);
        } else if (++robot->ticks % 20 == 0) {
            report(robot);
        }
    }
}

int main(int argc, char *argv[])
{
    Robot robot = { .pid = { .kp = 24.0, .ki = 1.0, .kd = 4.0, .limit = 350.0 }, .mode = &SEEK };
    double seconds = argc > 1 ? atof(argv[1]) : 90.0;
    int call;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "follow_wall: no robot\n");
        return 1;
    }
    conf_tm(2);
    conf_sn(10, order);
    ac(300, 300, 0);
    dp(0, 0);
    da(0, 0);
    for (call = 0; call < 30; call++)    /* until each sonar has fired */
        gs();

    run(&robot, (int) (seconds / TICK));

    st();
    ws(1, 1, 0, 5);
    printf("stopped at (%.1f, %.1f)\n", State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0);
    disconnect_robot(ROBOT_ID);
    return EXIT_SUCCESS;
}
