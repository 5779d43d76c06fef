/*
 * slide.c - a Nomad 200 follows a wall closely by infrared alone.
 *
 * Sonars cannot measure such short distances; infrared sensors can. Each measures how
 * much of its own light is reflected, 0 to 15, approximately the inches to the surface,
 * and 15 if nothing is near. Number 4 points to the left, 3 and 5 by 22.5 degrees to its
 * sides.
 *
 * The wheels are steered by the distance of the wall (4) and by its direction (3 and 5);
 * the base and the turret keep their direction. A dark wall reflects less light, and
 * appears farther away: the robot gets closer. The program cannot detect this.
 *
 * Usage:  crs run slide.c wavy.xml
 */

#include <stdio.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define KEEP       7            /* reading of the sensor to the left */
#define NOTHING    15
#define SPEED      60           /* 0.1 inch/s */
#define STEER_MAX  150          /* 0.1 degree/s */
#define HEADING_MAX 400         /* maximum angle between wheels and turret, 0.1 degree */
#define WAY        2500         /* 0.1 inch */
#define MAX_TURNS  1200

static int order[16] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15 };

static int limited(int value, int most)
{
    return value > most ? most : value < -most ? -most : value;
}

/* Returns the direction of the wheels relative to the start, 0.1 degree. */
static int wheels(void)
{
    int angle = (int) State[STATE_CONF_STEER];

    return angle > 1800 ? angle - 3600 : angle;
}

int main(void)
{
    int turns = 0, aside, along, wanted, lost = 0, count[NOTHING + 1] = { 0 }, i;

    if (!connect_robot(ROBOT_ID, MODEL_N200, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "slide: no robot\n");
        return 1;
    }
    conf_ir(5, order);                     /* average each reading with the previous one */
    conf_tm(5);
    ac(100, 300, 300);
    sp(SPEED, STEER_MAX, 300);
    dp(0, 0);
    da(0, 0);

    printf("     x     y  wheels  ahead  left  behind\n");
    while (State[STATE_CONF_X] < WAY && State[STATE_BUMPER] == 0 && turns++ < MAX_TURNS) {
        get_ir();
        aside = (int) State[STATE_IR_4] - KEEP;
        along = (int) (State[STATE_IR_3] - State[STATE_IR_5]);
        if (State[STATE_IR_4] == NOTHING && State[STATE_IR_3] == NOTHING)
            lost++;
        count[State[STATE_IR_4]]++;
        wanted = limited(35 * aside + 20 * along, HEADING_MAX);
        vm(SPEED, limited(2 * (wanted - wheels()), STEER_MAX), 0);
        if (turns % 25 == 1)
            printf("%6.1f %5.1f  %6.1f  %5ld %5ld  %6ld\n", State[STATE_CONF_X] / 10.0,
                   State[STATE_CONF_Y] / 10.0, wheels() / 10.0, State[STATE_IR_3],
                   State[STATE_IR_4], State[STATE_IR_5]);
        usleep(60000);
    }
    st();
    ws(1, 1, 1, 5);
    printf("how often the sensor to the left read\n");
    for (i = 0; i <= NOTHING; i++)
        if (count[i])
            printf("%6d  %5d\n", i, count[i]);
    printf("lost the wall %d times\n", lost);
    disconnect_robot(ROBOT_ID);
    return lost || State[STATE_CONF_X] < WAY;
}
