/* Sonar beams drawn into an occupancy grid with Bresenham lines; a map printed. */
#include <stdio.h>
#include <math.h>
#include <string.h>

#define W 40
#define H 16

static signed char grid[H][W];

static void mark(int x, int y, int by)
{
    int v;

    if (x < 0 || x >= W || y < 0 || y >= H)
        return;
    v = grid[y][x] + by;
    grid[y][x] = v > 9 ? 9 : v < -9 ? -9 : v;
}

static void beam(int x0, int y0, int x1, int y1, int hit)
{
    int dx = x1 > x0 ? x1 - x0 : x0 - x1, dy = y1 > y0 ? y0 - y1 : y1 - y0;
    int sx = x0 < x1 ? 1 : -1, sy = y0 < y1 ? 1 : -1, error = dx + dy, twice;

    while (x0 != x1 || y0 != y1) {
        mark(x0, y0, -1);
        twice = 2 * error;
        if (twice >= dy)
            error += dy, x0 += sx;
        if (twice <= dx)
            error += dx, y0 += sy;
    }
    mark(x1, y1, hit ? 3 : -1);
}

static double range_to_wall(double x, double y, double a)
{
    double best = 30, c = cos(a), s = sin(a), d;

    if (c > 1e-9 && (d = (W - 2 - x) / c) < best)
        best = d;
    if (c < -1e-9 && (d = (1 - x) / c) < best)
        best = d;
    if (s > 1e-9 && (d = (H - 2 - y) / s) < best)
        best = d;
    if (s < -1e-9 && (d = (1 - y) / s) < best)
        best = d;
    return best;
}

int main(void)
{
    int step, i, x, y, counts[3] = { 0 };

    for (step = 0; step < 4; step++) {
        double px = 6 + 8 * step, py = 5 + 2 * step;
        for (i = 0; i < 16; i++) {
            double a = i * 3.14159265358979 / 8, d = range_to_wall(px, py, a);
            beam((int) px, (int) py, (int) floor(px + d * cos(a) + 0.5),
                 (int) floor(py + d * sin(a) + 0.5), d < 30);
        }
    }
    for (y = H - 1; y >= 0; y--) {
        for (x = 0; x < W; x++) {
            int v = grid[y][x];
            putchar(v > 0 ? '#' : v < 0 ? '.' : ' ');
            counts[v > 0 ? 0 : v < 0 ? 1 : 2]++;
        }
        putchar('\n');
    }
    printf("%d %d %d\n", counts[0], counts[1], counts[2]);
    return 0;
}
