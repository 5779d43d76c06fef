/*
 * tour.c - one of several robots that look for the shortest round tour over all stations, as an ant
 * of the Ant System.
 *
 * A robot knows where the stations are, and its place by GPS and compass. From each station it goes
 * to one where it has not been yet, which it remembers in its tabu list, at random:
 *
 *     P(there) is in proportion to (UNMARKED + smell of the way there)^ALPHA / distance^BETA
 *
 * Back at the beginning it walks the same tour once more, and lays a trail, the more the shorter the
 * tour: MARKS / length. This is the rule of "ant-cycle" of
 * M. Dorigo, V. Maniezzo, A. Colorni, Ant System: optimization by a colony of cooperating agents,
 * IEEE Transactions on Systems, Man, and Cybernetics B 26 (1996). What evaporates is up to the field
 * of the world. The robot prints a line for each tour: when it was chosen, its length, and its order.
 *
 * Usage:  crs run tour.xml
 */

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define SPEED    140            /* 0.1 inch/s */
#define NEAR     0.8            /* of the range of infrared sensors */
#include "walk.h"

#define ALPHA    2.0            /* how much the trail counts */
#define BETA     3.0            /* how much it counts that a station is near */
#define UNMARKED 1.0            /* as if this much lay on each way */
#define MARKS    40.0           /* m: what a robot lays in a cell, times the length of its tour */
#define CELL     0.1            /* m: of the field */
#define REACH    0.6            /* m: of the three antennae */
#define THERE    0.12           /* m: this near to a station a robot is at it */

static const struct station {
    double x, y;                /* m */
} stations[] = {
    { 3.2, 2.4 }, { 1.0, 2.0 }, { 2.6, 0.5 }, { 3.4, 1.5 }, { 1.5, 2.8 }, { 2.4, 2.9 }, { 1.6, 0.5 },
};

#define STATIONS ((int)(sizeof stations / sizeof *stations))

static int trail;               /* the field */

static double distance(int from, int to)
{
    return hypot(stations[to].x - stations[from].x, stations[to].y - stations[from].y);
}

/* Returns the length of a tour, in metres. */
static double length_of(const int tour[STATIONS])
{
    double length = 0;
    int i;

    for (i = 0; i < STATIONS; i++)
        length += distance(tour[i], tour[(i + 1) % STATIONS]);
    return length;
}

static void go_to_station(int station)
{
    go_to(stations[station].x, stations[station].y, THERE);
}

/* Returns what the robot smells on the way between two stations, at the first of which it is: the
   antennae, side by side, reach across the way, also if the robot is beside its beginning. */
static double smell_of_way(int from, int to)
{
    double east = (stations[to].x - stations[from].x) / distance(from, to);
    double north = (stations[to].y - stations[from].y) / distance(from, to);
    double x = place_x - stations[from].x, y = place_y - stations[from].y;
    double aside = y * east - x * north;
    double along = x * east + y * north + sqrt(REACH * REACH - aside * aside);

    face(atan2(along * north - y, along * east - x));
    return crs_smell(trail, 0) + crs_smell(trail, 1) + crs_smell(trail, 2);
}

/* Returns the station to go to next: at random, one that is not in the tabu list. */
static int choose(int here, const int tabu[STATIONS])
{
    double weights[STATIONS] = { 0 }, sum = 0, drawn;
    int there, last = here;

    for (there = 0; there < STATIONS; there++)
        if (!tabu[there]) {
            weights[there] = pow(UNMARKED + smell_of_way(here, there), ALPHA)
                             / pow(distance(here, there), BETA);
            sum += weights[there];
        }
    drawn = sum * rand() / RAND_MAX;
    for (there = 0; there < STATIONS; there++)
        if (!tabu[there]) {
            last = there;
            if ((drawn -= weights[there]) <= 0)
                break;
        }
    return last;
}

/* Walks a new tour, from a station and back to it. */
static void find_tour(int tour[STATIONS], int station)
{
    int tabu[STATIONS] = { 0 }, i;

    for (i = 0; i < STATIONS; i++) {
        tour[i] = i == 0 ? station : choose(tour[i - 1], tabu);
        tabu[tour[i]] = 1;
        go_to_station(tour[i]);
    }
    go_to_station(station);
}

/* Walks a tour again, and lays a trail on it. */
static void mark_tour(const int tour[STATIONS])
{
    int i;

    crs_lay_trail(trail, MARKS / length_of(tour) / CELL);
    for (i = 1; i <= STATIONS; i++)
        go_to_station(tour[i % STATIONS]);
    crs_lay_trail(trail, 0);
}

static void print_tour(const int tour[STATIONS])
{
    struct timespec now;
    int i;

    clock_gettime(CLOCK_MONOTONIC, &now);
    printf("%ld %.3f ", (long)now.tv_sec, length_of(tour));
    for (i = 0; i < STATIONS; i++)
        printf("%d", tour[i]);
    putchar('\n');
}

int main(void)
{
    int tour[STATIONS];

    trail = crs_find_field("trail");
    if (!connect_robot(1) || trail < 0)
        return 1;
    conf_tm(0);
    look();
    srand((unsigned)(1e6 * place_x + 1e3 * place_y));   /* another place for each robot and seed */
    tour[0] = crs_my_number() % STATIONS;
    for (;;) {
        find_tour(tour, tour[0]);
        print_tour(tour);
        mark_tour(tour);
    }
}
