/*
 * maze.c - one of several robots that look for the shortest way through a maze, as an ant of simple
 * ant colony optimisation.
 *
 * A robot knows the walls and its place, but not the way. From the nest it goes from cell to cell, not
 * back unless it has to, at random where it can choose:
 *
 *     P(cell) is in proportion to (UNMARKED + smell of the cell)^ALPHA
 *
 * until it is at the food. It leaves out the loops of its way, and goes back by what remains. There it
 * marks each cell, the more the shorter the way is: MARKS / cells. This is S-ACO of M. Dorigo,
 * T. Stuetzle, Ant Colony Optimization (MIT Press 2004), section 1.3; what evaporates is up to the
 * field of the world. The robot prints a line at the food: when, and the length of its way in metres.
 *
 * Usage:  crs run maze.xml
 */

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define SPEED    100            /* 0.1 inch/s */
#define NEAR     0.5            /* of the range of infrared sensors: less than to the walls */
#include "walk.h"

#define ALPHA    2.0            /* how much the trail counts */
#define UNMARKED 1.0            /* as if this much lay in each cell */
#define MARKS    40.0           /* what a robot lays in a cell, times the cells of its way */
#define CELL     0.6            /* m: of the maze, and of the field */
#define LANE     0.13           /* m: robots keep to the right by so much */
#define THERE    0.12           /* m: this near to its aim a robot is there */

#define COLUMNS  7
#define ROWS     5
#define CELLS    (COLUMNS * ROWS)

/* Cells are at odd places, walls between them; the first row is the northern one. */
static const char maze[2 * ROWS + 1][2 * COLUMNS + 2] = {
    "+-+-+-+-+-+-+-+",
    "|             |",
    "+ +-+-+-+-+-+ +",
    "|     | |     |",
    "+-+-+ + + +-+-+",
    "|     | | |   |",
    "+ + +-+ + + + +",
    "| |     |   | |",
    "+ + + + +-+-+ +",
    "|             |",
    "+-+-+-+-+-+-+-+",
};

static const struct cell {
    int x, y;                   /* from the south-western one */
} nest = { 0, 2 }, food = { 6, 2 };

static const struct cell sides[] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };

static int trail;               /* the field */

static int is_same(struct cell one, struct cell other)
{
    return one.x == other.x && one.y == other.y;
}

/* Returns the neighbour of a cell on one of its four sides. */
static struct cell beside(struct cell cell, int side)
{
    struct cell other = { cell.x + sides[side].x, cell.y + sides[side].y };

    return other;
}

static int is_open(struct cell cell, int side)
{
    return maze[2 * (ROWS - 1 - cell.y) + 1 - sides[side].y][2 * cell.x + 1 + sides[side].x] == ' ';
}

/* Drives to the next cell, on the right side of the corridor. */
static void step(struct cell from, struct cell to)
{
    int east = to.x - from.x, north = to.y - from.y;

    go_to((to.x + 0.5) * CELL + north * LANE, (to.y + 0.5) * CELL - east * LANE, THERE);
}

/* Returns the side to which the robot leaves a cell, with another one to go back to if it must. */
static int choose(struct cell here, int back)
{
    double weights[4] = { 0 }, sum = 0, drawn;
    int side, ways = 0, last = back;

    for (side = 0; side < 4; side++)
        if (side != back && is_open(here, side)) {
            ways++;
            last = side;
        }
    if (ways < 2)
        return last;
    for (side = 0; side < 4; side++)
        if (side != back && is_open(here, side)) {
            face(side * PI / 2);
            weights[side] = pow(UNMARKED + crs_smell(trail, 1), ALPHA);
            sum += weights[side];
        }
    drawn = sum * rand() / RAND_MAX;
    for (side = 0; side < last; side++)
        if (weights[side] > 0 && (drawn -= weights[side]) <= 0)
            break;
    return side;
}

/* Goes from the nest to the food; returns the number of steps of the way without its loops. */
static int find_way(struct cell way[CELLS])
{
    int steps = 0, back = -1, side, i;

    way[0] = nest;
    while (!is_same(way[steps], food)) {
        struct cell next = beside(way[steps], side = choose(way[steps], back));

        step(way[steps], next);
        back = (side + 2) % 4;
        for (i = 0; i <= steps && !is_same(way[i], next); i++)
            ;
        way[steps = i] = next;
    }
    return steps;
}

/* Goes back to the nest, and marks each cell. */
static void mark_way(const struct cell way[CELLS], int steps)
{
    int i;

    for (i = steps; i > 0; i--) {
        step(way[i], way[i - 1]);
        crs_deposit(trail, MARKS / steps);
    }
}

int main(void)
{
    struct cell way[CELLS];
    struct timespec now;

    trail = crs_find_field("trail");
    if (!connect_robot(1) || trail < 0)
        return 1;
    conf_tm(0);
    look();
    srand((unsigned)(1e6 * place_x + 1e3 * place_y));   /* noisy: another one for each seed */
    sleep(3 * crs_my_number());
    go_to((nest.x + 0.5) * CELL, (nest.y + 0.5) * CELL, CELL / 2);
    for (;;) {
        int steps = find_way(way);

        clock_gettime(CLOCK_MONOTONIC, &now);
        printf("%ld %.1f\n", (long)now.tv_sec, steps * CELL);
        mark_way(way, steps);
    }
}
