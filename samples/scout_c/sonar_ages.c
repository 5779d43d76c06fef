/*
 * sonar_ages.c - how old are the readings of the sonars, and does it matter?
 *
 * One sonar fires at a time, each rate x 4 ms after the previous one, in the order given to
 * conf_sn(), but not before the last one has listened long enough for a distant echo: a small
 * rate is not as fast as it seems. A reading stays in State until its sonar fires again: with all
 * sixteen at the usual rate of 15 it is up to 0.96 s old, and the robot has moved on.
 *
 * The sensor board records the time and the robot's position for each reading (posData). Here the
 * robot drives towards a wall with several settings, and prints for each sonar, in its order,
 *
 *     the age of its reading, in ms, and how far the robot went since, in inches
 *
 * and for the front sonar the distance that it reads, and that distance minus the distance driven
 * since: what it would read now.
 *
 * Usage:  crs run sonar_ages.c wall.xml
 */

#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID  1
#define SPEED     100        /* 0.1 inch/s */
#define END       255        /* of an order */

static struct setting {
    const char *name;
    int rate;                /* units of 4 ms */
    int order[16];
} settings[] = {
    { "all sixteen, rate 15", 15, { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 } },
    { "all sixteen, rate 5", 5, { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 } },
    { "five ahead, rate 15", 15, { 0, 2, 15, 1, 14, END } },
    { "one ahead, rate 10", 10, { 0, END } },
};

static int count(const int *order)
{
    int n = 0;

    while (n < 16 && order[n] != END)
        n++;
    return n;
}

static void show(struct setting *s)
{
    PosData ring[16];
    long reading, time;
    double since, oldest = 0.0;
    int n = count(s->order), i, age;

    conf_sn(s->rate, s->order);
    usleep(2000000);                   /* all sonars have fired since */
    gs();                              /* reads distances, positions and times */
    posSonarRingGet(ring);
    time = posTimeGet();
    reading = State[STATE_SONAR_0];
    printf("%s: %d ms for a round\n", s->name, n * s->rate * 4);
    for (i = 0; i < n; i++) {
        const PosData *p = &ring[s->order[i]];

        age = (int) (time - (long) p->timeStamp);
        since = hypot(State[STATE_CONF_X] - p->config.configX,
                      State[STATE_CONF_Y] - p->config.configY) / 10.0;
        oldest = fmax(oldest, age);
        printf("  #%-2d %4d ms %4.1f in%s", s->order[i], age, since, i % 4 == 3 ? "\n" : "   ");
    }
    since = (State[STATE_CONF_X] - ring[0].config.configX) / 10.0;
    printf("%s  oldest %.0f ms; ahead %ld in, now %.1f in\n", n % 4 ? "\n" : "", oldest, reading,
           reading - since);
}

int main(void)
{
    unsigned i;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "sonar_ages: no robot\n");
        return 1;
    }
    posDataRequest(POS_SONAR);
    conf_tm(10);
    ac(200, 200, 0);
    dp(0, 0);
    da(0, 0);
    scout_vm(SPEED, 0);
    for (i = 0; i < sizeof settings / sizeof *settings; i++)
        show(&settings[i]);
    st();
    ws(1, 1, 0, 5);
    printf("motors %.1f V, computer %.1f V\n", voltMotorGet(), voltCpuGet());
    disconnect_robot(ROBOT_ID);
    return 0;
}
