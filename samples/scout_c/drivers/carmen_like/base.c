/*
 * base.c - a base server: receives velocities, publishes the pose.
 *
 * A toolkit's base server gets its commands from other programs; here they come from a
 * table. As there, a command is valid for one second only: without a new one, the robot
 * stops. A signal ends the server, and its handler stops the robot.
 *
 * This file does not include the client's header, as was common. So vm(0.0, 0.0, 0.0) is
 * called without a prototype and its arguments are not converted to integers; it stops
 * the robot nevertheless, because the bits of a double zero are all zero. crs prints a
 * warning.
 *
 * Usage:  crs run drivers/carmen_like/base.c drivers/carmen_like/scout_base.c studio.xml
 */

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "base_direct.h"

#define PERIOD       100000     /* microseconds */
#define PUBLISH      10         /* iterations per output */
#define TIMEOUT      1.0        /* seconds that a command is valid */
#define NUM_SONARS   16
#define NUM_BUMPERS  8

typedef struct {
    double start, end;          /* seconds */
    double tv, rv;              /* m/s, rad/s */
} Command;

/* No commands between 14 and 17 s: the server stops the robot. */
static const Command commands[] = {
    { 1.0, 9.0, 0.25, 0.0 },
    { 9.0, 12.0, 0.10, M_PI / 6.0 },
    { 12.0, 14.0, 0.20, 0.0 },
    { 17.0, 19.0, -0.10, 0.0 },
    { 19.0, 22.0, 0.0, -M_PI / 6.0 },
};

static volatile sig_atomic_t quit;
static int first = 1;

static void shutdown_base(int sig)
{
    quit = sig;
    vm(0.0, 0.0, 0.0);
}

static const Command *command_at(double seconds)
{
    unsigned i;

    for (i = 0; i < sizeof commands / sizeof commands[0]; i++)
        if (seconds >= commands[i].start && seconds < commands[i].end)
            return &commands[i];
    return NULL;
}

/* Prints what a toolkit would publish. */
static void publish(double seconds, double way)
{
    double x, y, theta, tv, rv, ranges[NUM_SONARS];
    unsigned char bumpers[NUM_BUMPERS];
    int i, bumped = 0;

    base_direct_get_integrated_state(&x, &y, &theta, &tv, &rv);
    base_direct_get_bumpers(bumpers, NUM_BUMPERS);
    for (i = 0; i < NUM_BUMPERS; i++)
        bumped |= bumpers[i];
    if (first)
        printf("     s        x       y   theta      tv      rv     way  bump   ahead  left "
               "behind right\n");
    first = 0;
    printf("%6.2f  %7.3f %7.3f %7.3f  %6.3f  %6.3f  %6.3f  %4d ", seconds, x, y, theta, tv, rv,
           way, bumped);
    if (base_direct_get_sonars(ranges, NUM_SONARS) == 0)
        for (i = 0; i < NUM_SONARS; i += 4)
            printf("  %5.2f", ranges[i]);
    printf("\n");
}

int main(int argc, char **argv)
{
    char *model = argc > 1 ? argv[1] : "scout", *dev = argc > 2 ? argv[2] : "/dev/ttyS0";
    double start, now, told = 0.0, displacement, rotation, way = 0.0, turned = 0.0;
    const Command *command;
    unsigned char *state;
    int turns, size, moving = 0;

    if (base_direct_initialize_robot(model, dev) < 0) {
        fprintf(stderr, "base: no robot, or an unknown model: %s\n", model);
        return 1;
    }
    if (base_direct_reset() < 0 || base_direct_sonar_on() < 0
        || base_direct_set_acceleration(0.5) < 0 || base_direct_set_deceleration(0.4) < 0) {
        fprintf(stderr, "base: the robot does not take its settings\n");
        return 1;
    }
    signal(SIGINT, shutdown_base);
    signal(SIGALRM, shutdown_base);
    alarm(24);                           /* like Ctrl-C */
    start = get_time();
    for (turns = 0; !quit; turns++) {
        now = get_time() - start;
        command = command_at(now);
        if (command != NULL) {
            base_direct_set_velocity(command->tv, command->rv);
            told = now;
            moving = 1;
        } else if (moving && now - told > TIMEOUT) {
            printf("%6.2f  no command for %.0f s: stopped\n", now, TIMEOUT);
            base_direct_set_velocity(0.0, 0.0);
            moving = 0;
        }
        base_direct_update_status();
        base_direct_get_state(&displacement, &rotation, NULL, NULL);
        way += displacement;
        turned += rotation;
        if (turns % PUBLISH == 0)
            publish(now, way);
        usleep(PERIOD);
    }
    printf("signal %d: driven %.2f m, turned by %.2f rad\n", quit, way, turned);
    base_direct_sonar_off();
    if (base_direct_get_binary_data(&state, &size) == 0) {
        printf("%d bytes of state, the ring ahead says %ld\n", size, ((long *) state)[17]);
        free(state);
    }
    base_direct_shutdown_robot();
    return 0;
}
