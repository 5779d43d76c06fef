/*
 * log_drive.c - drive for a while, log everything to a file, then read the log.
 *
 * Ten times a second a record is written to LOG, as one line of numbers:
 *
 *     seconds  x  y  heading  right  left  bumper  16 sonars
 *
 * in inches, degrees, inches/s. After the drive the file is opened again, read with
 * fscanf(), and summarised: distance, speed, and the nearest echo of each sonar.
 *
 * Usage:  crs run log_drive.c room.xml --files logs
 *
 * The log is then in logs/drive.log.
 */

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <sys/time.h>
#include "Nclient.h"

#define ROBOT_ID  1
#define N_SONARS  16
#define LOG       "drive.log"
#define RECORDS   400
#define SPEED     80
#define NEAR      20          /* obstacle ahead: turn, inches */
#define FREE      36          /* free distance needed to continue, inches */

struct record {
    double seconds, x, y, heading, right, left;
    long bumper;
    long sonar[N_SONARS];
};

static int order[N_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };

static FILE *open_log(const char *mode)
{
    FILE *file = fopen(LOG, mode);

    if (file == NULL) {
        fprintf(stderr, "log_drive: %s: %s\n", LOG, strerror(errno));
        exit(1);
    }
    return file;
}

static double seconds_since(const struct timeval *start)
{
    struct timeval now;

    gettimeofday(&now, NULL);
    return now.tv_sec - start->tv_sec + (now.tv_usec - start->tv_usec) / 1e6;
}

static void write_record(FILE *log, double seconds)
{
    int i;

    fprintf(log, "%.3f %.1f %.1f %.1f %.1f %.1f %ld", seconds, State[STATE_CONF_X] / 10.0,
            State[STATE_CONF_Y] / 10.0, State[STATE_CONF_STEER] / 10.0,
            State[STATE_VEL_RIGHT] / 10.0, State[STATE_VEL_LEFT] / 10.0, State[STATE_BUMPER]);
    for (i = 0; i < N_SONARS; i++)
        fprintf(log, " %ld", State[STATE_SONAR_0 + i]);
    if (fputc('\n', log) == EOF)
        perror(LOG);
}

/* Returns 1 if a whole record was read. */
static int read_record(FILE *log, struct record *r)
{
    int i;

    if (fscanf(log, "%lf %lf %lf %lf %lf %lf %ld", &r->seconds, &r->x, &r->y, &r->heading,
               &r->right, &r->left, &r->bumper) != 7)
        return 0;
    for (i = 0; i < N_SONARS; i++)
        if (fscanf(log, "%ld", &r->sonar[i]) != 1)
            return 0;
    return 1;
}

static long ahead(void)
{
    long nearest = State[STATE_SONAR_0];

    if (State[STATE_SONAR_1] < nearest)
        nearest = State[STATE_SONAR_1];
    if (State[STATE_SONAR_15] < nearest)
        nearest = State[STATE_SONAR_15];
    return nearest;
}

/* Drives straight ahead, and turns left at obstacles. */
static void drive(FILE *log)
{
    struct timeval start;
    int count, turning = 0;

    gettimeofday(&start, NULL);
    for (count = 0; count < RECORDS; count++) {
        turning = ahead() < (turning ? FREE : NEAR);
        if (turning)
            scout_vm(0, 300);          /* updates State */
        else
            scout_vm(SPEED, 0);
        write_record(log, seconds_since(&start));
        usleep(100000);
    }
    st();
    ws(1, 1, 0, 5);
}

static void sum_up(FILE *log)
{
    struct record last = { 0 }, now;
    long nearest[N_SONARS];
    double way = 0.0, fastest = 0.0, turned = 0.0;
    int count = 0, bumps = 0, i;

    for (i = 0; i < N_SONARS; i++)
        nearest[i] = 255;
    while (read_record(log, &now)) {
        if (count++ > 0) {
            way += hypot(now.x - last.x, now.y - last.y);
            turned += fabs(remainder(now.heading - last.heading, 360.0));
        }
        fastest = fmax(fastest, (now.right + now.left) / 2.0);
        bumps += now.bumper != 0 && last.bumper == 0;
        for (i = 0; i < N_SONARS; i++)
            if (now.sonar[i] < nearest[i])
                nearest[i] = now.sonar[i];
        last = now;
    }
    printf("%d records, %ld bytes, %.1f s\n", count, ftell(log), last.seconds);
    printf("driven %.1f in at up to %.1f in/s, turned by %.0f degrees, bumped %d times\n", way,
           fastest, turned, bumps);
    printf("nearest");
    for (i = 0; i < N_SONARS; i++)
        printf(" %ld", nearest[i]);
    printf("\n");
}

int main(void)
{
    FILE *log;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "log_drive: no robot\n");
        return 1;
    }
    conf_tm(2);
    conf_sn(15, order);
    ac(200, 200, 0);
    dp(0, 0);
    da(0, 0);
    usleep(1000000);          /* until each sonar has fired */
    gs();

    log = open_log("w");
    fprintf(log, "# seconds x y heading right left bumper sonars\n");
    drive(log);
    fclose(log);
    disconnect_robot(ROBOT_ID);

    log = open_log("r");
    fscanf(log, "#%*[^\n]");
    sum_up(log);
    fclose(log);
    return 0;
}
