/* Conway's Game of Life on a torus: a glider and a blinker. */
#include <stdio.h>
#include <string.h>

#define H 10
#define W 16

typedef char World[H][W];

static int neighbours(World w, int i, int j)
{
    int di, dj, n = 0;

    for (di = -1; di <= 1; di++)
        for (dj = -1; dj <= 1; dj++)
            if (di || dj)
                n += w[(i + di + H) % H][(j + dj + W) % W];
    return n;
}

static void step(World now, World next)
{
    int i, j;

    for (i = 0; i < H; i++)
        for (j = 0; j < W; j++) {
            int n = neighbours(now, i, j);
            next[i][j] = n == 3 || (n == 2 && now[i][j]);
        }
}

static void show(World w)
{
    int i, j, alive = 0;

    for (i = 0; i < H; i++) {
        for (j = 0; j < W; j++) {
            putchar(w[i][j] ? '#' : '.');
            alive += w[i][j];
        }
        putchar('\n');
    }
    printf("%d alive\n", alive);
}

int main(void)
{
    static World a, b;
    const char *cells[] = { ".#", "..#", "###" };
    int i, j, t;

    for (i = 0; i < 3; i++)
        for (j = 0; cells[i][j]; j++)
            a[i][j] = cells[i][j] == '#';
    a[6][10] = a[6][11] = a[6][12] = 1;
    show(a);
    for (t = 0; t < 12; t++) {
        step(a, b);
        memcpy(a, b, sizeof a);
    }
    show(a);
    return 0;
}
