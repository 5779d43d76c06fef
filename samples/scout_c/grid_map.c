/*
 * grid_map.c - draw a map of a room: an occupancy grid from sonar readings.
 *
 * The robot drives through a list of points and stops every STEP inches until each sonar
 * has fired once. A reading of r inches means two things (Moravec and Elfes 1985): the
 * inside of the beam up to r is free, and somewhere on the arc at r there is an obstacle.
 * Each cell of the grid stores the logarithm of the odds that it is occupied, so evidence
 * is simply added; evidence for free is stronger near the axis of the beam, and evidence
 * for occupied is divided over the arc: the longer the arc, the less for each cell.
 *
 * At the end the grid is printed:  # occupied  . free  + where the robot stopped
 *
 * Usage:  crs run grid_map.c studio.xml
 *
 * The list of points is for the room of studio.xml, from its start.
 */

#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define N_SONARS   16
#define SHELL      8.0      /* radius of the robot, inches */
#define NO_ECHO    255
#define STEP       14.0     /* between two stops, inches */
#define CELL       5.0      /* side of a cell, inches */
#define BEAM       10.0     /* half width of the beam, degrees */
#define FAR        70.0     /* ignore readings beyond this: often a glancing wall, inches */
#define THICK      3.0      /* half thickness of the arc, inches */
#define FREE       20.0     /* evidence on the axis of the beam */
#define OCCUPIED   260.0    /* evidence for a whole arc */
#define LIMIT      120      /* limit of the odds */

typedef signed char Odds;

typedef struct {
    double left, bottom;    /* corner of the first cell, inches */
    int columns, rows;
    Odds **cell;            /* row by row, from the bottom */
} Grid;

typedef struct { double x, y; } Place;

static const Place places[] = {
    { 125, 0 }, { 125, 34 }, { 72, 34 }, { 72, 85 }, { 5, 88 }, { 5, 80 }, { 0, 5 },
};

static int order[N_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };

static void *allocate(size_t count, size_t size)
{
    void *block = calloc(count, size);

    if (block == NULL) {
        fprintf(stderr, "grid_map: no memory\n");
        exit(1);
    }
    return block;
}

static Grid *make_grid(double left, double bottom, double right, double top)
{
    Grid *grid = allocate(1, sizeof *grid);
    int row;

    grid->left = left;
    grid->bottom = bottom;
    grid->columns = (int) ceil((right - left) / CELL);
    grid->rows = (int) ceil((top - bottom) / CELL);
    grid->cell = allocate(grid->rows, sizeof *grid->cell);
    for (row = 0; row < grid->rows; row++)
        grid->cell[row] = allocate(grid->columns, sizeof **grid->cell);
    return grid;
}

static void free_grid(Grid *grid)
{
    while (grid->rows > 0)
        free(grid->cell[--grid->rows]);
    free(grid->cell);
    free(grid);
}

static void add(Odds *odds, double evidence)
{
    double sum = *odds + evidence;

    *odds = (Odds) (sum > LIMIT ? LIMIT : sum < -LIMIT ? -LIMIT : sum);
}

/* Returns the first and the last index of cells within a distance of a point. */
static void window(double place, double start, double reach, int count, int *first, int *last)
{
    *first = (int) floor((place - reach - start) / CELL);
    *last = (int) floor((place + reach - start) / CELL);
    if (*first < 0)
        *first = 0;
    if (*last >= count)
        *last = count - 1;
}

/* Adds one reading of a sonar at (x, y) with a direction, in radians. */
static void enter(Grid *grid, double x, double y, double direction, double reading)
{
    double reach = fmin(reading, FAR) + THICK;
    double arc = fmax(2.0 * BEAM * M_PI / 180.0 * reading / CELL, 1.0);   /* in cells */
    double dx, dy, distance, off;
    int row, column, low, high, first, last;

    window(y, grid->bottom, reach, grid->rows, &low, &high);
    window(x, grid->left, reach, grid->columns, &first, &last);
    for (row = low; row <= high; row++)
        for (column = first; column <= last; column++) {
            dx = grid->left + (column + 0.5) * CELL - x;
            dy = grid->bottom + (row + 0.5) * CELL - y;
            distance = hypot(dx, dy);
            if (distance > reach)
                continue;
            off = fabs(remainder(atan2(dy, dx) - direction, 2.0 * M_PI)) * 180.0 / M_PI / BEAM;
            if (off > 1.0)
                continue;
            if (distance < reading - THICK)
                add(&grid->cell[row][column], -FREE * (1.0 - off * off));
            else if (reading <= FAR)
                add(&grid->cell[row][column], OCCUPIED / arc / arc * (1.0 - 0.5 * off));
        }
}

/* Waits until each sonar has fired, and adds the readings. */
static void scan(Grid *grid)
{
    double x, y, heading, direction;
    int i;

    usleep(1100000);
    gs();
    x = State[STATE_CONF_X] / 10.0;
    y = State[STATE_CONF_Y] / 10.0;
    heading = State[STATE_CONF_STEER] * M_PI / 1800.0;
    for (i = 0; i < N_SONARS; i++) {
        if (State[STATE_SONAR_0 + i] == NO_ECHO)
            continue;               /* nothing there, or a glancing wall */
        direction = heading + i * 2.0 * M_PI / N_SONARS;
        enter(grid, x + SHELL * cos(direction), y + SHELL * sin(direction), direction,
              State[STATE_SONAR_0 + i]);
    }
}

static void turn_to(double degrees)
{
    double turn = remainder(degrees - State[STATE_CONF_STEER] / 10.0, 360.0);

    if (fabs(turn) < 1.0)
        return;
    scout_pr(0, (int) (10.0 * turn));
    ws(1, 1, 0, 20);
}

/* Drives to a point, with a scan every STEP inches; returns the number of scans. */
static int go(Grid *grid, Place to, Place *stops)
{
    double dx, dy, way;
    int scans = 0;

    for (;;) {
        dx = to.x - State[STATE_CONF_X] / 10.0;
        dy = to.y - State[STATE_CONF_Y] / 10.0;
        way = hypot(dx, dy);
        if (way < 1.0)
            return scans;
        turn_to(atan2(dy, dx) * 180.0 / M_PI);
        scout_pr((int) (10.0 * fmin(way, STEP)), 0);
        ws(1, 1, 0, 20);
        scan(grid);
        stops[scans].x = State[STATE_CONF_X] / 10.0;
        stops[scans++].y = State[STATE_CONF_Y] / 10.0;
    }
}

static void print_grid(const Grid *grid, const Place *stops, int count)
{
    char *line = allocate(grid->columns + 1, 1);
    int row, column, i;

    for (row = grid->rows - 1; row >= 0; row--) {
        for (column = 0; column < grid->columns; column++) {
            Odds odds = grid->cell[row][column];
            line[column] = odds > 20 ? '#' : odds < -20 ? '.' : ' ';
        }
        for (i = 0; i < count; i++)
            if ((int) floor((stops[i].y - grid->bottom) / CELL) == row)
                line[(int) floor((stops[i].x - grid->left) / CELL)] = '+';
        printf("%6.1f |%s|\n", grid->bottom + (row + 0.5) * CELL, line);
    }
    free(line);
}

int main(void)
{
    Place stops[100];
    Grid *grid;
    size_t i;
    int scans = 0;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "grid_map: no robot\n");
        return 1;
    }
    conf_tm(5);
    conf_sn(15, order);
    ac(200, 200, 0);
    sp(100, 100, 0);
    dp(0, 0);
    da(0, 0);

    grid = make_grid(-60.0, -50.0, 180.0, 130.0);
    scan(grid);
    for (i = 0; i < sizeof places / sizeof *places; i++) {
        scans += go(grid, places[i], stops + scans);
        printf("at (%5.1f, %5.1f) after %d scans\n", State[STATE_CONF_X] / 10.0,
               State[STATE_CONF_Y] / 10.0, scans);
    }
    print_grid(grid, stops, scans);
    free_grid(grid);
    disconnect_robot(ROBOT_ID);
    return 0;
}
