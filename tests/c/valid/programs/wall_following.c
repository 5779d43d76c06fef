/* Wall following in the style of the early 1990s: State[], globals, K&R functions, and a little
   room of its own in place of the robot. */
#include <stdio.h>
#include <math.h>

#define STATE_SONAR_0 17
#define STATE_CONF_X 34
#define STATE_CONF_Y 35
#define STATE_CONF_STEER 36
#define FRONT State[STATE_SONAR_0]
#define LEFT State[STATE_SONAR_0 + 4]
#define RIGHT State[STATE_SONAR_0 + 12]
#define TOO_NEAR 14
#define WANTED 20
#define TRUE 1
#define FALSE 0

long State[45];
int Smask[44];
static double x = 60.0, y = 50.0, heading;      /* inches, radians */
static int step_count;

double distance_to_wall();
int gs();

int connect_robot(id)
    int id;
{
    printf("connected to robot %d\n", id);
    return gs();
}

double distance_to_wall(angle)
    double angle;
{
    double dx = cos(angle), dy = sin(angle), d = 255, t;

    if (dx > 1e-9 && (t = (200 - x) / dx) < d) d = t;
    if (dx < -1e-9 && (t = -x / dx) < d) d = t;
    if (dy > 1e-9 && (t = (120 - y) / dy) < d) d = t;
    if (dy < -1e-9 && (t = -y / dy) < d) d = t;
    return d;
}

int gs()
{
    register i;

    for (i = 0; i < 16; i++)
        State[STATE_SONAR_0 + i] = (long) (distance_to_wall(heading + i * M_PI / 8) + 0.5);
    State[STATE_CONF_X] = (long) floor(x * 10 + 0.5);
    State[STATE_CONF_Y] = (long) floor(y * 10 + 0.5);
    State[STATE_CONF_STEER] = (long) floor(heading * 1800 / M_PI + 0.5);
    return TRUE;
}

vm(trans, steer)
    int trans, steer;   /* tenths of inches, tenths of degrees per second */
{
    heading += steer * 0.1 * M_PI / 180 * 0.5;
    x += trans * 0.1 * 0.5 * cos(heading);
    y += trans * 0.1 * 0.5 * sin(heading);
    step_count++;
    return gs();
}

int limit(value, most)
{
    if (value > most)
        return (most);
    if (value < -most)
        return (-most);
    return (value);
}

follow_wall(turns)
    int turns;
{
    int corner = 0, was_corner = FALSE, error, steer;

    while (corner < turns && step_count < 2000) {
        if (FRONT < TOO_NEAR + WANTED) {
            steer = 450;
            if (!was_corner)
                corner++;
            was_corner = TRUE;
            vm(20, steer);
        } else {
            was_corner = FALSE;
            error = WANTED - (int) RIGHT;
            steer = limit(error * 20 + (int) (State[STATE_SONAR_0 + 13] < 22 ? 60 : 0), 300);
            vm(100, steer);
        }
        if (step_count % 6 == 0)
            printf("%4d: (%4ld, %4ld) right %3ld front %3ld\n", step_count,
                   State[STATE_CONF_X] / 10, State[STATE_CONF_Y] / 10, RIGHT, FRONT);
    }
    return corner;
}

main()
{
    int corners;

    if (!connect_robot(1)) {
        printf("no robot\n");
        return 1;
    }
    corners = follow_wall(6);
    printf("%d corners in %d steps\n", corners, step_count);
    return 0;
}
