/* Occupancy grid mapping: simulated sonar rays, Bresenham's line, log odds, the map in letters. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#define SIZE 24
#define FREE (-2)
#define HIT 5
#define LIMIT 20

static signed char grid[SIZE][SIZE];

static const char *const world[] = {
    "########################",
    "#......................#",
    "#......................#",
    "#....####..............#",
    "#....####..............#",
    "#......................#",
    "#......................#",
    "#.................##...#",
    "#.................##...#",
    "#......................#",
    "#......................#",
    "########################",
};
static const int rows = sizeof world / sizeof world[0];

static int is_wall(int x, int y)
{
    return y < 0 || y >= rows || x < 0 || x >= SIZE || world[y][x] == '#';
}

static void add(int x, int y, int amount)
{
    int value = grid[y][x] + amount;
    grid[y][x] = (signed char) (value > LIMIT ? LIMIT : value < -LIMIT ? -LIMIT : value);
}

/* Marks cells from (x0, y0) as free, the first one that is a wall as hit. */
static int ray(int x0, int y0, int x1, int y1)
{
    int dx = x1 > x0 ? x1 - x0 : x0 - x1, dy = y1 > y0 ? y0 - y1 : y1 - y0;
    int sx = x0 < x1 ? 1 : -1, sy = y0 < y1 ? 1 : -1, error = dx + dy, length = 0;

    for (;;) {
        if (is_wall(x0, y0)) {
            if (x0 >= 0 && x0 < SIZE && y0 >= 0 && y0 < SIZE)
                add(x0, y0, HIT);
            return length;
        }
        add(x0, y0, FREE);
        if (x0 == x1 && y0 == y1)
            return length;
        int twice = 2 * error;
        if (twice >= dy) {
            error += dy;
            x0 += sx;
        }
        if (twice <= dx) {
            error += dx;
            y0 += sy;
        }
        length++;
    }
}

int main(void)
{
    static const int stops[][2] = { { 2, 2 }, { 12, 2 }, { 21, 5 }, { 14, 9 }, { 3, 9 } };
    int total = 0, counts[3] = { 0 };

    for (unsigned s = 0; s < sizeof stops / sizeof *stops; s++)
        for (int i = 0; i < 32; i++) {
            double angle = i * 3.14159265358979 / 16;
            int x = stops[s][0] + (int) floor(18 * cos(angle) + 0.5);
            int y = stops[s][1] + (int) floor(18 * sin(angle) + 0.5);
            total += ray(stops[s][0], stops[s][1], x, y);
        }
    for (int y = 0; y < rows; y++) {
        char line[SIZE + 1];
        for (int x = 0; x < SIZE; x++) {
            int state = grid[y][x] > 3 ? 2 : grid[y][x] < -3 ? 0 : 1;
            counts[state]++;
            line[x] = ".?#"[state];
        }
        line[SIZE] = '\0';
        puts(line);
    }
    printf("%d %d %d %d\n", total, counts[0], counts[1], counts[2]);
    return 0;
}
