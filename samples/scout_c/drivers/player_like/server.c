/*
 * server.c - a device server with one driver: a loop at 10 Hz until a signal comes.
 *
 * Each iteration updates the driver and sends it a command, here from a small client that
 * avoids obstacles. Every two seconds the interfaces are printed.
 *
 * Usage:  crs run -std=gnu89 drivers/player_like/server.c drivers/player_like/nomad.c room.xml
 */

# include <signal.h>
# include <stdio.h>
# include <stdlib.h>
# include <unistd.h>
# include <sys/time.h>
# include "driver.h"

# define PERIOD     100000L        /* microseconds */
# define SECONDS    40

static int quit;

static
on_signal(sig)
{
    quit = sig;
}

static long
micros()
{
    struct timeval t;

    gettimeofday(&t, (struct timezone *) 0);
    return t.tv_sec % 100000 * 1000000L + t.tv_usec;
}

static double
nearest(r, first, last)
    ranger_data *r;
{
    double best = 1e9;

    for (; first <= last; first++)
        if (r->ranges[(first + r->count) % r->count] < best)
            best = r->ranges[(first + r->count) % r->count];
    return best;
}

/* The client: straight ahead while free, otherwise a turn to the freer side. */
static
client(d, vx, va)
    driver *d;
    double *vx, *va;
{
    static double side = 1.0;
    double ahead = nearest(&d->sonar, -2, 2);

    if (ahead > 0.45) {
        *vx = ahead > 0.9 ? 0.20 : 0.10;
        *va = 0.0;
        side = nearest(&d->sonar, 1, 4) > nearest(&d->sonar, -4, -1) ? 1.0 : -1.0;
    } else {
        *vx = 0.0;
        *va = 0.5 * side;
    }
}

static
print(d, seconds)
    driver *d;
    double seconds;
{
    int i, bumped = 0;

    for (i = 0; i < d->bumper.count; i++)
        bumped += d->bumper.bumpers[i];
    printf("%5.1f position %6.3f %6.3f %6.3f  speed %6.3f %6.3f  sonar %.2f %.2f %.2f %.2f  "
           "bumpers %d  %.1f V\n", seconds, d->position.px, d->position.py, d->position.pa,
           d->position.vx, d->position.va, d->sonar.ranges[0], d->sonar.ranges[4],
           d->sonar.ranges[8], d->sonar.ranges[12], bumped, d->power.volts);
}

main(argc, argv)
    char **argv;
{
    driver *d = &nomad_driver;
    long start, turn = 0, late = 0, rest;
    double vx, va;

    if ((*d->setup)(d, argc, argv) < 0) {
        fprintf(stderr, "%s: cannot be set up\n", d->name);
        exit(1);
    }
    signal(SIGINT, on_signal);
    signal(SIGTERM, on_signal);
    usleep(1000000);               /* until all sonars have fired */
    start = micros();
    while (!quit) {
        if ((*d->update)(d) == 0) {
            client(d, &vx, &va);
            (*d->command)(d, vx, va);
        }
        if (turn % 20 == 0)
            print(d, (micros() - start) / 1e6);
        if (turn == SECONDS * 10)
            raise(SIGTERM);
        rest = start + ++turn * PERIOD - micros();
        if (rest > 0)
            usleep(rest);
        else
            late++;
    }
    printf("signal %d after %ld updates, %ld failed, %ld turns late\n", quit, d->updates,
           d->failures, late);
    exit((*d->shutdown)(d) < 0);
}
