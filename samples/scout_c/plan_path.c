/*
 * plan_path.c - plan a path on a map with a wavefront, and follow it.
 *
 * The map is a grid of characters. All cells too close to an obstacle are closed for the
 * robot's centre. A wave that starts at the goal numbers the remaining cells by their
 * distance (Jarvis 1984), and descending from the start gives a shortest path. Corners
 * that can be cut in a straight line are cut.
 *
 * Before that, a recursive flood fill determines whether there is a path at all.
 *
 * While driving, the front sonars are monitored: if there is an obstacle that is not on
 * the map, the robot stops and reports it.
 *
 * Usage:  crs run plan_path.c office.xml --file worlds/office.grid
 *         ... -- MAP X Y           another map or goal, inches on the map
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID   1
#define MAX_CELLS  128        /* in each direction */
#define KEEP       12.1       /* clearance of the robot's centre from full cells, inches */
#define BLOCKED    9          /* obstacle ahead: stop, inches */
#define FULL       '#'
#define START_X    39.4       /* where the robot of office.xml starts, inches */
#define START_Y    167.3

typedef struct { int column, row; } Cell;

static char floor_plan[MAX_CELLS][MAX_CELLS + 2];   /* row 0 is y = 0 */
static char closed[MAX_CELLS][MAX_CELLS];
static char reached[MAX_CELLS][MAX_CELLS];
static int wave[MAX_CELLS][MAX_CELLS];              /* steps to the goal, -1: unreachable */
static int columns, rows;
static double cell_size;

static int order[16] = { 0, 1, 15, 2, 14, 255 };

static void fail(const char *what, const char *which)
{
    fprintf(stderr, "plan_path: %s: %s\n", which, what);
    exit(1);
}

/* ---- the map ---- */

static void read_map(const char *name)
{
    FILE *file = fopen(name, "r");
    char line[MAX_CELLS + 2], swap[MAX_CELLS + 2];
    int low, high;

    if (file == NULL)
        fail("cannot be opened", name);
    while (fgets(line, sizeof line, file) != NULL) {
        line[strcspn(line, "\r\n")] = '\0';
        if (*line == ';' || *line == '\0' || sscanf(line, "cell %lf", &cell_size) == 1)
            continue;
        if (rows == MAX_CELLS)
            fail("too many rows", name);
        if (rows > 0 && (int) strlen(line) != columns)
            fail("rows of different length", name);
        columns = strlen(line);
        strcpy(floor_plan[rows++], line);
    }
    fclose(file);
    if (cell_size <= 0.0 || rows == 0)
        fail("has no size of cells, or no rows", name);
    for (low = 0, high = rows - 1; low < high; low++, high--) {   /* y grows upwards */
        strcpy(swap, floor_plan[low]);
        strcpy(floor_plan[low], floor_plan[high]);
        strcpy(floor_plan[high], swap);
    }
}

static int is_inside(Cell c)
{
    return c.column >= 0 && c.column < columns && c.row >= 0 && c.row < rows;
}

/* Closes all cells within KEEP of a full one, and those at the edge of the map. */
static void close_cells(void)
{
    int reach = (int) (KEEP / cell_size), row, column, dr, dc;
    Cell near;

    for (row = 0; row < rows; row++)
        for (column = 0; column < columns; column++)
            for (dr = -reach; dr <= reach; dr++)
                for (dc = -reach; dc <= reach; dc++) {
                    near.row = row + dr;
                    near.column = column + dc;
                    if (hypot(dr, dc) * cell_size <= KEEP
                        && (!is_inside(near) || floor_plan[near.row][near.column] == FULL))
                        closed[row][column] = 1;
                }
}

static int is_open(Cell c)
{
    return is_inside(c) && !closed[c.row][c.column];
}

static Cell cell_at(double x, double y)
{
    Cell c = { (int) (x / cell_size), (int) (y / cell_size) };

    return c;
}

/* ---- the plan ---- */

static const Cell sides[8] = {
    { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 }, { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 },
};

static Cell beside(Cell c, int side)
{
    c.column += sides[side].column;
    c.row += sides[side].row;
    return c;
}

/* Marks all cells reachable from a cell. */
static int flood(Cell c)
{
    int side, count = 1;

    if (!is_open(c) || reached[c.row][c.column])
        return 0;
    reached[c.row][c.column] = 1;
    for (side = 0; side < 4; side++)
        count += flood(beside(c, side));
    return count;
}

/* Numbers the cells by their steps from the goal, with a queue. */
static void spread(Cell goal)
{
    Cell *queue = malloc(sizeof *queue * rows * columns), *head = queue, *tail = queue, next;
    int side;

    if (queue == NULL)
        fail("no memory", "queue");
    memset(wave, -1, sizeof wave);
    wave[goal.row][goal.column] = 0;
    *tail++ = goal;
    while (head < tail) {
        for (side = 0; side < 4; side++) {
            next = beside(*head, side);
            if (is_open(next) && wave[next.row][next.column] < 0) {
                wave[next.row][next.column] = wave[head->row][head->column] + 1;
                *tail++ = next;
            }
        }
        head++;
    }
    free(queue);
}

/* Returns whether all cells on the straight line between two cells are open. */
static int in_sight(Cell from, Cell to)
{
    int steps = 2 * (abs(to.column - from.column) + abs(to.row - from.row)), i;
    Cell c;

    for (i = 0; i <= steps; i++) {
        c.column = (int) floor(from.column + 0.5 + (double) (to.column - from.column) * i / steps);
        c.row = (int) floor(from.row + 0.5 + (double) (to.row - from.row) * i / steps);
        if (!is_open(c))
            return 0;
    }
    return 1;
}

/* Follows the wave down to the last visible cell: the next corner of the path. */
static Cell next_corner(Cell from)
{
    Cell c = from, corner = from, next;
    int side;

    while (wave[c.row][c.column] > 0) {
        for (side = 0; side < 8; side++) {
            next = beside(c, side);
            if (is_open(next) && wave[next.row][next.column] >= 0
                && wave[next.row][next.column] < wave[c.row][c.column])
                break;
        }
        if (!in_sight(from, next))
            break;
        corner = c = next;
    }
    return corner;
}

/* ---- the drive ---- */

static double x(void)
{
    return START_X + State[STATE_CONF_X] / 10.0;
}

static double y(void)
{
    return START_Y + State[STATE_CONF_Y] / 10.0;
}

/* Drives to a point on the map; returns FALSE if it is blocked. */
static int drive(double to_x, double to_y)
{
    double heading = atan2(to_y - y(), to_x - x()) * 180.0 / M_PI;
    double turn = remainder(heading - State[STATE_CONF_STEER] / 10.0, 360.0);
    double rest;
    int speed;

    scout_pr(0, (int) (10.0 * turn));
    ws(1, 1, 0, 20);
    while ((rest = hypot(to_x - x(), to_y - y())) > 2.0) {
        heading = atan2(to_y - y(), to_x - x()) * 180.0 / M_PI;
        turn = remainder(heading - State[STATE_CONF_STEER] / 10.0, 360.0);
        if (fabs(turn) > 60.0)       /* we are past it */
            break;
        speed = rest < 12.0 ? 40 : 120;   /* not inside: scout_vm() is a macro */
        scout_vm(speed, (int) (12.0 * turn));
        get_sn();
        if (State[STATE_SONAR_0] < BLOCKED) {
            st();
            return FALSE;
        }
        usleep(40000);
        gs();
    }
    st();
    ws(1, 1, 0, 5);
    return TRUE;
}

static void print_plan(const char *marks)
{
    int row, column;

    for (row = rows - 1; row >= 0; row--) {
        for (column = 0; column < columns; column++) {
            char mark = marks[row * columns + column];
            putchar(mark ? mark : floor_plan[row][column] == FULL ? '#'
                                  : closed[row][column] ? ' ' : '.');
        }
        putchar('\n');
    }
}

int main(int argc, char **argv)
{
    const char *map = argc > 1 ? argv[1] : "worlds/office.grid";
    double goal_x = argc > 3 ? atof(argv[2]) : 413.0, goal_y = argc > 3 ? atof(argv[3]) : 260.0;
    Cell start, goal, corners[MAX_CELLS], c;
    int count = 0, i;
    char *marks;

    read_map(map);
    close_cells();
    start = cell_at(START_X, START_Y);
    goal = cell_at(goal_x, goal_y);
    printf("%d x %d cells of %g in, %d of them can be reached\n", columns, rows, cell_size,
           flood(start));
    if (!is_open(goal) || !reached[goal.row][goal.column]) {
        printf("there is no way to (%.0f, %.0f)\n", goal_x, goal_y);
        return 1;
    }
    spread(goal);

    marks = calloc(rows, columns);
    if (marks == NULL)
        fail("no memory", "marks");
    for (c = start; wave[c.row][c.column] > 0 && count < MAX_CELLS; c = corners[count - 1]) {
        corners[count++] = next_corner(c);
        marks[c.row * columns + c.column] = count == 1 ? 'S' : 'a' + (count - 2) % 26;
    }
    marks[goal.row * columns + goal.column] = 'G';
    print_plan(marks);
    free(marks);

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400))
        fail("no answer", "robot");
    conf_tm(5);
    conf_sn(15, order);
    ac(200, 200, 0);
    sp(100, 100, 0);
    dp(0, 0);
    da(0, 0);
    for (i = 0; i < count; i++) {
        int free_way = drive((corners[i].column + 0.5) * cell_size,
                             (corners[i].row + 0.5) * cell_size);

        get_rc();
        printf("%d of %d: (%.1f, %.1f)\n", i + 1, count, x(), y());
        if (!free_way) {
            printf("something stands in the way\n");
            disconnect_robot(ROBOT_ID);
            return 1;
        }
    }
    printf("arrived %.1f in from the goal\n", hypot(x() - goal_x, y() - goal_y));
    disconnect_robot(ROBOT_ID);
    return 0;
}
