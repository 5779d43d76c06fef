/*
 * behaviours.c - a stack of behaviours; the topmost active one controls the robot.
 *
 * Each behaviour is a pair of functions: wants() evaluates the sensors and returns
 * whether it is active, act() sets the wheel speeds. The arbiter tests them from top to
 * bottom, as the layers of a subsumption architecture (Brooks 1986) suppress those below
 * them:
 *
 *     escape    a bumper is pressed: back off, then turn
 *     avoid     something is close ahead: turn in place to the open side
 *     veer      something comes near at a shoulder: bend away from it
 *     explore   straight on for long enough: take another direction by chance
 *     cruise    always: straight on
 *
 * Whenever another behaviour takes over, a line is printed; at the end, the total time of
 * each.
 *
 * Usage:  crs run behaviours.c cluttered.xml             90 seconds
 *         crs run behaviours.c cluttered.xml -- 30 7     30 seconds, chance from 7
 */

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/time.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID    1
#define PERIOD      100000L     /* time per decision, microseconds */
#define CLOSE       13          /* obstacle ahead: turn away, inches */
#define OPEN        22          /* free ahead: continue, inches */
#define NEAR        11          /* obstacle beside: steer away, inches */
#define CRUISE      80          /* 0.1 inch/s */
#define SPIN        350         /* 0.1 degree/s */

typedef struct {
    int ahead, left, right;     /* nearest echoes, inches */
    int behind;
    int bumped;
    double time;                /* seconds since the start */
} Senses;

typedef struct {
    int trans, steer;           /* arguments of scout_vm() */
} Command;

typedef struct {
    const char *name;
    int (*wants)(const Senses *);
    Command (*act)(const Senses *);
    int turns;                  /* how often it was chosen */
} Behaviour;

static int order[16] = { 0, 15, 1, 14, 2, 12, 4, 8, 255 };
static struct timeval started;

/* ---- log with time stamps ---- */

static double now(void)
{
    struct timeval t;

    gettimeofday(&t, NULL);
    return t.tv_sec - started.tv_sec + (t.tv_usec - started.tv_usec) / 1e6;
}

static void say(const char *format, ...)
{
    va_list arguments;

    printf("%6.1f  ", now());
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
}

/* ---- sensors ---- */

static int nearest(const int *sonars)
{
    int best = 255;

    for (; *sonars >= 0; sonars++)
        if (State[STATE_SONAR_0 + *sonars] < best)
            best = State[STATE_SONAR_0 + *sonars];
    return best;
}

static Senses sense(void)
{
    static const int ahead[] = { 15, 0, 1, -1 };
    static const int left[] = { 2, 4, -1 };
    static const int right[] = { 14, 12, -1 };
    Senses s;

    gs();
    s.ahead = nearest(ahead);
    s.left = nearest(left);
    s.right = nearest(right);
    s.behind = State[STATE_SONAR_8];
    s.bumped = State[STATE_BUMPER] != 0;
    s.time = now();
    return s;
}

/* ---- behaviours; each keeps its own state ---- */

static int escape_wants(const Senses *s)
{
    static double until;

    if (s->bumped)
        until = s->time + 2.5;
    return s->time < until;
}

static Command escape(const Senses *s)
{
    static int steps;
    Command back = { -50, 0 }, turn = { 0, SPIN };

    steps = s->bumped ? 0 : steps + 1;
    return steps < 10 && s->behind > 6 ? back : turn;
}

static int turning;             /* 1 to the left, -1 to the right, 0: avoid is inactive */

static int avoid_wants(const Senses *s)
{
    if (turning == 0 && s->ahead < CLOSE)
        turning = s->left >= s->right ? 1 : -1;
    else if (turning != 0 && s->ahead > OPEN)
        turning = 0;
    return turning != 0;
}

static Command avoid(const Senses *s)
{
    Command c = { 0, turning * SPIN };

    (void) s;
    return c;
}

static int veer_wants(const Senses *s)
{
    return s->left < NEAR || s->right < NEAR;
}

static Command veer(const Senses *s)
{
    Command c = { CRUISE / 2, 25 * (s->right < s->left ? NEAR - s->right : s->left - NEAR) };

    return c;
}

static double turn_at, turn_until;

static int explore_wants(const Senses *s)
{
    if (turn_at == 0.0 || s->time > turn_until) {
        turn_at = s->time + 4.0 + rand() % 5;
        turn_until = turn_at + 1.0 + rand() % 3;
    }
    return s->time > turn_at;
}

static Command explore(const Senses *s)
{
    static double chosen_for;
    static int side;
    Command c = { CRUISE / 2, 0 };

    if (chosen_for != turn_at) {
        chosen_for = turn_at;
        side = rand() & 1 ? 1 : -1;
    }
    (void) s;
    c.steer = side * 300;
    return c;
}

static int always(const Senses *s)
{
    (void) s;
    return 1;
}

static Command cruise(const Senses *s)
{
    Command c = { s->ahead < 2 * OPEN ? CRUISE / 2 : CRUISE, 0 };

    return c;
}

static Behaviour stack[] = {
    { "escape",  escape_wants,  escape },
    { "avoid",   avoid_wants,   avoid },
    { "veer",    veer_wants,    veer },
    { "explore", explore_wants, explore },
    { "cruise",  always,        cruise },
};

#define LAYERS (sizeof stack / sizeof *stack)

/* Returns the topmost active behaviour. */
static Behaviour *arbitrate(const Senses *s)
{
    Behaviour *b = stack;

    while (!b->wants(s))
        b++;
    b->turns++;
    return b;
}

static int by_turns(const void *a, const void *b)
{
    return ((const Behaviour *) b)->turns - ((const Behaviour *) a)->turns;
}

int main(int argc, char *argv[])
{
    double seconds = argc > 1 ? atof(argv[1]) : 90.0;
    const Behaviour *last = NULL, *chosen;
    Senses s;
    Command c;
    int total = 0;
    size_t i;

    srand(argc > 2 ? atoi(argv[2]) : 1);
    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "behaviours: no robot\n");
        return 1;
    }
    conf_tm(2);
    conf_sn(15, order);
    ac(200, 200, 0);
    dp(0, 0);
    da(0, 0);
    usleep(600000);             /* until each sonar has fired */
    gettimeofday(&started, NULL);

    while ((s = sense()).time < seconds) {
        chosen = arbitrate(&s);
        c = chosen->act(&s);
        scout_vm(c.trans, c.steer);
        total++;
        if (chosen != last)
            say("%-8s at (%6.1f, %6.1f)  ahead %3d  left %3d  right %3d", chosen->name,
                State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0, s.ahead, s.left, s.right);
        last = chosen;
        usleep(PERIOD);
    }
    st();
    say("stopped after %d decisions", total);
    qsort(stack, LAYERS, sizeof *stack, by_turns);
    for (i = 0; i < LAYERS; i++)
        printf("%-8s %5.1f %%\n", stack[i].name, 100.0 * stack[i].turns / total);
    disconnect_robot(ROBOT_ID);
    return 0;
}
