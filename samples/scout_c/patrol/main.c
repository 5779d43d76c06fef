/*
 * main.c - a night watch: patrols a corridor and checks whether doors are closed.
 *
 * At each door of the list the robot stops in the corridor, turns to the door and
 * listens. A closed door answers from the wall, an open one from the end of the
 * room behind. Then it goes home and reports.
 *
 *     main.c     the round
 *     motion.c   driving
 *     sense.c    listening
 *     watch.c    the time
 *     patrol.h   what they share
 *
 * Usage:  crs run -std=gnu89 patrol/main.c patrol/motion.c patrol/sense.c patrol/watch.c night.xml
 *
 * The language is that of its time: gcc -traditional or -std=gnu89.
 */

# include "patrol.h"

struct door list[] = {
    { "store room",  INCHES(74),   90 },
    { "workshop",    INCHES(144), -90 },
    { "library",     INCHES(224),  90 },
    { "office",      INCHES(284), -90 },
};

/* Turns to a door, measures, and turns back. */
visit(d)
    register struct door *d;
{
    if (!go_to(d->where))
        return FALSE;
    face(d->side);
    d->depth = look();
    d->state = clear_ahead() ? OPEN : CLOSED;
    tick();
    printf("%2ld:%02ld  %-12s %-8s nothing for %d inches\n", minutes, seconds, d->name,
           state_name(d->state), d->depth);
    face(0);
    return TRUE;
}

report()
{
    int i, open = 0;

    for (i = 0; i < n_doors; i++)
        open += doors[i].state == OPEN;
    printf("%d doors, %d open, %d closed", n_doors, open, n_doors - open);
    if (bumps)
        printf(", bumped %d times", bumps);
    printf("\n");
    return open;
}

main(argc, argv)
    int argc;
    char **argv;
{
    int i;

    doors = list;
    n_doors = sizeof list / sizeof list[0];
    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "%s: the robot does not answer\n", argc > 0 ? argv[0] : "patrol");
        exit(1);
    }
    start_watch();
    start_motion();
    start_sonars();
    for (i = 0; i < n_doors; i++)
        if (!visit(&doors[i])) {
            printf("the way is blocked\n");
            break;
        }
    go_to(0L);
    tick();
    printf("%2ld:%02ld  home at (%ld, %ld) tenths of an inch\n", minutes, seconds,
           State[STATE_CONF_X], State[STATE_CONF_Y]);
    report();
    halt();
    disconnect_robot(ROBOT_ID);
    exit(0);
}
