/* A* on a grid with obstacles, costs for turning, and a path drawn into the map. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 20
#define HEIGHT 10

static char map[HEIGHT][WIDTH + 1] = {
    "....................",
    ".S....##............",
    "......##...#######..",
    "......##...#.....#..",
    "...........#..G..#..",
    "..########.#.....#..",
    "..#........####.##..",
    "..#.................",
    "..#...#########.....",
    "....................",
};

typedef struct { int x, y; } Cell;

static const Cell steps[4] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
static struct node { int cost; signed char from; unsigned open : 1, closed : 1; } nodes[HEIGHT][WIDTH];

static Cell find(char wanted)
{
    Cell c;
    for (c.y = 0; c.y < HEIGHT; c.y++)
        for (c.x = 0; c.x < WIDTH; c.x++)
            if (map[c.y][c.x] == wanted)
                return c;
    return (Cell) { -1, -1 };
}

static int estimate(Cell a, Cell b) { return 10 * (abs(a.x - b.x) + abs(a.y - b.y)); }

static int best_open(Cell goal, Cell *best)
{
    int least = INT_MAX, found = 0;
    Cell c;
    for (c.y = 0; c.y < HEIGHT; c.y++)
        for (c.x = 0; c.x < WIDTH; c.x++) {
            struct node *n = &nodes[c.y][c.x];
            if (n->open && !n->closed && n->cost + estimate(c, goal) < least) {
                least = n->cost + estimate(c, goal);
                *best = c;
                found = 1;
            }
        }
    return found;
}

static int search(Cell start, Cell goal)
{
    int looked_at = 0;
    Cell at;
    nodes[start.y][start.x].open = 1;
    while (best_open(goal, &at)) {
        struct node *here = &nodes[at.y][at.x];
        if (at.x == goal.x && at.y == goal.y)
            return looked_at;
        here->closed = 1;
        looked_at++;
        for (int i = 0; i < 4; i++) {
            Cell to = { at.x + steps[i].x, at.y + steps[i].y };
            if (to.x < 0 || to.x >= WIDTH || to.y < 0 || to.y >= HEIGHT || map[to.y][to.x] == '#')
                continue;
            struct node *there = &nodes[to.y][to.x];
            int cost = here->cost + 10 + (looked_at > 1 && here->from != i ? 3 : 0);
            if (there->closed || (there->open && there->cost <= cost))
                continue;
            there->open = 1;
            there->cost = cost;
            there->from = (signed char) i;
        }
    }
    return -1;
}

int main(void)
{
    Cell start = find('S'), goal = find('G'), at = goal;
    int looked_at = search(start, goal), length = 0;

    printf("%d cells looked at, cost %d\n", looked_at, nodes[goal.y][goal.x].cost);
    while (at.x != start.x || at.y != start.y) {
        int from = nodes[at.y][at.x].from;
        at.x -= steps[from].x;
        at.y -= steps[from].y;
        if (map[at.y][at.x] == '.')
            map[at.y][at.x] = ">v<^"[from];
        length++;
    }
    for (int y = 0; y < HEIGHT; y++)
        puts(map[y]);
    printf("%d steps\n", length);
    return 0;
}
