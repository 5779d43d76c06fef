/*
 * bounce.c - cross a room with bumpers only, like early cleaning robots.
 *
 * The robot drives straight until a bumper closes, backs up a few inches, turns away from
 * the side that was hit by a random angle, and continues. For each contact it prints the
 * bits of State[STATE_BUMPER] and the position, and at the end the area covered: the
 * squares of 10 inches that the robot's centre has crossed, one bit for each.
 *
 * The sonars are off: an order that starts with 255 fires none.
 *
 * Usage:  crs run bounce.c room.xml            12 contacts
 *         crs run bounce.c room.xml -- 5       5 contacts
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define SPEED      90        /* 0.1 inch/s */
#define BACK       40        /* 0.1 inch */
#define SWITCHES   8         /* bumpers, 45 degrees apart, counterclockwise from the front */
#define SQUARE     100       /* 0.1 inch */
#define SQUARES    64        /* in each direction, from the centre */

/* The motor status word, by name. */
typedef union {
    long word;
    struct {
        unsigned right_moves : 1;
        unsigned left_moves : 1;
        unsigned turret_moves : 1;
        unsigned : 29;
    } is;
} MotorStatus;

/* The floor: a bit for each square. */
struct floor_bits {
    unsigned long row[SQUARES][SQUARES / 32];
    unsigned count : 12;
    unsigned outside : 1;
};

static struct floor_bits seen;

static void mark(long x, long y)
{
    int column = (int) (x + SQUARES / 2 * SQUARE) / SQUARE;
    int row = (int) (y + SQUARES / 2 * SQUARE) / SQUARE;
    unsigned long bit;

    if (row < 0 || row >= SQUARES || column < 0 || column >= SQUARES) {
        seen.outside = 1;
        return;
    }
    bit = 1UL << column % 32;
    if (!(seen.row[row][column / 32] & bit)) {
        seen.row[row][column / 32] |= bit;
        seen.count++;
    }
}

/* Prints a bumper mask as a row of switches, the front one first. */
static const char *switches(long mask)
{
    static char text[SWITCHES + 1];
    int i;

    for (i = 0; i < SWITCHES; i++)
        text[i] = mask & 1L << i ? '#' : '.';
    return text;
}

/* Returns whether a mask has more switches on the left (1 to 3) than on the right. */
static int hit_left(long mask)
{
    int balance = 0, i;

    for (i = 1; i <= 3; i++)
        balance += !!(mask & 1L << i) - !!(mask & 1L << (SWITCHES - i));
    return balance > 0 || (balance == 0 && rand() & 1);
}

static void wait_until_it_stands(void)
{
    MotorStatus status;

    memset(&status, 0, sizeof status);
    do {
        gs();
        mark(State[STATE_CONF_X], State[STATE_CONF_Y]);
        usleep(40000);
        status.word = State[STATE_MOTOR_STATUS];
    } while (status.is.right_moves || status.is.left_moves);
}

int main(int argc, char **argv)
{
    static int none[16] = { 255 };
    int wanted = argc > 1 ? atoi(argv[1]) : 12, contact, angle;
    long hit;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "bounce: no robot\n");
        return 1;
    }
    srand(1);
    conf_tm(2);
    conf_sn(15, none);
    ac(300, 300, 0);
    sp(SPEED, SPEED, 0);
    dp(0, 0);
    da(0, 0);

    for (contact = 1; contact <= wanted; contact++) {
        do {
            scout_vm(SPEED, 0);
            mark(State[STATE_CONF_X], State[STATE_CONF_Y]);
            usleep(40000);
        } while (State[STATE_BUMPER] == 0);
        hit = State[STATE_BUMPER];
        st();
        printf("contact %2d  [%s]  at (%6.1f, %6.1f)  ", contact, switches(hit),
               State[STATE_CONF_X] / 10.0, State[STATE_CONF_Y] / 10.0);
        scout_pr(-BACK, 0);
        wait_until_it_stands();
        angle = 450 + rand() % 900;
        if (hit_left(hit))
            angle = -angle;
        printf("turning %s by %.1f degrees\n", angle > 0 ? "left" : "right", abs(angle) / 10.0);
        scout_pr(0, angle);
        wait_until_it_stands();
    }
    printf("%d contacts, %u squares of %d in crossed%s\n", wanted, seen.count, SQUARE / 10,
           seen.outside ? ", and more outside of the map" : "");
    disconnect_robot(ROBOT_ID);
    return 0;
}
