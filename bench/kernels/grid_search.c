/* Shortest ways over a grid with costs: Dijkstra with a binary heap, as a path planner has it. */
#include <stdio.h>
#include <string.h>

#define SIDE 128
#define FAR 1000000000

struct entry { int distance; short x, y; };

static unsigned char cost[SIDE][SIDE];
static int distance[SIDE][SIDE];
static struct entry heap[4 * SIDE * SIDE];
static int size;

static void push(int d, int x, int y)
{
    int i = size++, up;

    while (i > 0 && heap[up = (i - 1) / 2].distance > d) {
        heap[i] = heap[up];
        i = up;
    }
    heap[i].distance = d;
    heap[i].x = x;
    heap[i].y = y;
}

static struct entry pop(void)
{
    struct entry top = heap[0], last = heap[--size];
    int i = 0, down;

    while ((down = 2 * i + 1) < size) {
        if (down + 1 < size && heap[down + 1].distance < heap[down].distance)
            down++;
        if (heap[down].distance >= last.distance)
            break;
        heap[i] = heap[down];
        i = down;
    }
    heap[i] = last;
    return top;
}

static int search(int x0, int y0, int x1, int y1)
{
    static const int dx[4] = { 1, 0, -1, 0 }, dy[4] = { 0, 1, 0, -1 };
    int x, y, i;

    for (y = 0; y < SIDE; y++)
        for (x = 0; x < SIDE; x++)
            distance[y][x] = FAR;
    size = 0;
    distance[y0][x0] = 0;
    push(0, x0, y0);
    while (size > 0) {
        struct entry e = pop();
        if (e.distance > distance[e.y][e.x])
            continue;
        if (e.x == x1 && e.y == y1)
            return e.distance;
        for (i = 0; i < 4; i++) {
            int d;
            x = e.x + dx[i];
            y = e.y + dy[i];
            if (x < 0 || y < 0 || x >= SIDE || y >= SIDE || cost[y][x] == 0)
                continue;
            d = e.distance + cost[y][x];
            if (d < distance[y][x]) {
                distance[y][x] = d;
                push(d, x, y);
            }
        }
    }
    return -1;
}

int main(void)
{
    unsigned seed = 17;
    int x, y, round, sum = 0;

    for (y = 0; y < SIDE; y++)
        for (x = 0; x < SIDE; x++) {
            seed = seed * 1664525u + 1013904223u;
            cost[y][x] = seed >> 30 == 0 && x && y ? 0 : 1 + (seed >> 20) % 9;
        }
    for (round = 0; round < 40; round++) {
        cost[round][round * 5 % SIDE] = 1;
        sum = sum * 3 + search(round % 8, 0, SIDE - 1 - round % 5, SIDE - 1);
    }
    printf("grid_search %d\n", sum);
    return 0;
}
