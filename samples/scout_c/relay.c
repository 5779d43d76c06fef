/*
 * relay.c - carry messages around a wall that blocks radio.
 *
 * Three robots run this program, and each finds its role by its name. "source" reads its
 * sonars from time to time, and stores the readings. "base" needs them, but is out of
 * reach: a wall is in between. So "carrier" drives back and forth, calls, receives the
 * stored readings, and passes them on. A reading is stored until another robot
 * acknowledges it by its number; so none is lost, whatever the radio loses.
 *
 * Usage:  crs run relay.c radio-shadow.xml
 */

#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <sys/time.h>
#include "Nclient.h"
#include "crs.h"

#define READINGS   10        /* to be made, one each ... */
#define INTERVAL   5.0       /* seconds */
#define CALL       300       /* timeout of an answer, ms */
#define SILENCE    8         /* unanswered calls after which to give up */

enum type { HELLO, READING, GOT };      /* of messages: "who is there?", a reading, "I have it" */

struct reading {
    int number;
    int when;                /* ms */
    int ahead;               /* sonar 0, inches */
};

static struct reading kept[READINGS];
static int n_kept;
static char seen[READINGS];  /* whether a number was ever stored */

/* Returns the seconds since the first call. */
static double now(void)
{
    static long start;
    struct timeval time;

    gettimeofday(&time, NULL);
    if (start == 0)
        start = time.tv_sec;
    return time.tv_sec - start + time.tv_usec / 1e6;
}

/* Stores a reading if it is new; returns whether it is. */
static int keep(const struct reading *reading)
{
    if (reading->number < 0 || reading->number >= READINGS || seen[reading->number])
        return 0;
    seen[reading->number] = 1;
    kept[n_kept++] = *reading;
    return 1;
}

/* Extracts a reading from a message, acknowledges it, and stores it if it is new. */
static int accept(const struct crs_message *message, struct reading *reading)
{
    memcpy(reading, message->data, sizeof *reading);
    crs_send(message->from, GOT, &reading->number, sizeof reading->number);
    return keep(reading);
}

/* Drops a reading that another robot has acknowledged. */
static void drop(const struct crs_message *got)
{
    int i, number;

    memcpy(&number, got->data, sizeof number);
    for (i = 0; i < n_kept; i++)
        if (kept[i].number == number) {
            n_kept--;
            memmove(&kept[i], &kept[i + 1], (n_kept - i) * sizeof *kept);
            return;
        }
}

/* Sends the stored readings, oldest first, as long as the other robot acknowledges. */
static void hand_over(int to)
{
    struct crs_message answer;
    int tries = 0;

    while (n_kept > 0 && tries < SILENCE) {
        crs_send(to, READING, &kept[0], sizeof *kept);
        tries++;
        while (crs_receive(&answer, CALL))
            if (answer.type == GOT) {
                drop(&answer);
                tries = 0;
                break;
            }
    }
}

/* Calls, and receives readings until there are no more. */
static int take_over(int from)
{
    struct crs_message message;
    int silent = 0, taken = 0;

    while (silent < SILENCE) {
        crs_send(from, HELLO, NULL, 0);
        silent++;
        while (crs_receive(&message, CALL))
            if (message.type == READING) {
                struct reading reading;

                taken += accept(&message, &reading);
                silent = 0;
            }
    }
    return taken;
}

static void be_source(int base)
{
    struct crs_message message;
    int made = 0;
    double next = now();

    while (made < READINGS || n_kept > 0) {
        if (made < READINGS && now() >= next) {
            struct reading reading;

            get_sn();
            reading.number = made++;
            reading.when = (int)(now() * 1000);
            reading.ahead = State[STATE_SONAR_0];
            keep(&reading);
            crs_send(base, READING, &reading, sizeof reading);   /* who knows */
            next += INTERVAL;
        }
        if (crs_receive(&message, 100)) {
            if (message.type == HELLO)
                hand_over(message.from);
            else if (message.type == GOT)
                drop(&message);
        }
    }
    printf("all %d readings are gone\n", made);
}

static void be_base(int source)
{
    struct crs_message message;
    int got = 0, straight = 0;

    /* Stays for a while after the last reading: the carrier may not know yet. */
    while (crs_receive(&message, got < READINGS ? 200000 : 10000)) {
        struct reading reading;

        if (message.type != READING || !accept(&message, &reading))
            continue;
        got++;
        straight += message.from == source;
        printf("reading %d, %3d in at %5.1f s, is here at %5.1f s\n", reading.number,
               reading.ahead, reading.when / 1000.0, message.arrived / 1000.0);
    }
    printf("%d readings, %d of them straight from the source\n", got, straight);
}

static void go(int trans, int steer)
{
    scout_pr(trans, steer);
    ws(1, 1, 0, 120);
}

/* Drives around the wall: ahead, to the side, and back on the other side of it. */
static void drive_around(int side)
{
    go(1180, 0);
    go(0, side * 900);
    go(1890, 0);
    go(0, side * 900);
    go(1180, 0);
    go(0, 1800);
}

static void be_carrier(int source, int base)
{
    int carried = 0, trips = 0;

    sp(200, 200, 0);
    ac(200, 200, 0);
    while (carried < READINGS) {
        int taken = take_over(source), loaded = n_kept;

        if (loaded == 0)
            continue;
        drive_around(-1);
        hand_over(base);
        carried += loaded - n_kept;
        printf("trip %d: took over %d readings, %d are left\n", ++trips, taken, n_kept);
        if (carried < READINGS)
            drive_around(1);
    }
}

int main(void)
{
    int source = crs_find_robot("source"), base = crs_find_robot("base");
    int me = crs_my_number();

    if (source < 0 || base < 0 || !connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400))
        return 1;
    if (me == source)
        be_source(base);
    else if (me == base)
        be_base(source);
    else
        be_carrier(source, base);
    disconnect_robot(1);
    return 0;
}
