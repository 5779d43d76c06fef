/* Dijkstra with a binary heap, breadth first search and Floyd-Warshall agree. */
#include <stdio.h>

#define NODES 8
#define NONE 1000000

static const int edges[][3] = {
    { 0, 1, 4 }, { 0, 2, 1 }, { 2, 1, 2 }, { 1, 3, 5 }, { 2, 3, 8 }, { 3, 4, 3 }, { 4, 5, 1 },
    { 5, 3, 1 }, { 2, 6, 10 }, { 6, 4, 1 }, { 5, 0, 2 },
};
#define EDGES ((int) (sizeof edges / sizeof *edges))

struct item { int node, cost; };
static struct item heap[64];
static int heap_size;

static void push(int node, int cost)
{
    int i = heap_size++;

    while (i > 0 && heap[(i - 1) / 2].cost > cost) {
        heap[i] = heap[(i - 1) / 2];
        i = (i - 1) / 2;
    }
    heap[i] = (struct item) { node, cost };
}

static struct item pop(void)
{
    struct item top = heap[0], last = heap[--heap_size];
    int i = 0, child;

    while ((child = 2 * i + 1) < heap_size) {
        if (child + 1 < heap_size && heap[child + 1].cost < heap[child].cost)
            child++;
        if (heap[child].cost >= last.cost)
            break;
        heap[i] = heap[child];
        i = child;
    }
    heap[i] = last;
    return top;
}

static void dijkstra(int from, int *cost, int *before)
{
    int i;

    for (i = 0; i < NODES; i++)
        cost[i] = NONE, before[i] = -1;
    push(from, cost[from] = 0);
    while (heap_size) {
        struct item it = pop();
        if (it.cost > cost[it.node])
            continue;
        for (i = 0; i < EDGES; i++)
            if (edges[i][0] == it.node && it.cost + edges[i][2] < cost[edges[i][1]]) {
                before[edges[i][1]] = it.node;
                push(edges[i][1], cost[edges[i][1]] = it.cost + edges[i][2]);
            }
    }
}

static void path(const int *before, int to)
{
    if (before[to] >= 0)
        path(before, before[to]);
    printf("%d ", to);
}

int main(void)
{
    int all[NODES][NODES], cost[NODES], before[NODES], i, j, k, same = 1;

    for (i = 0; i < NODES; i++)
        for (j = 0; j < NODES; j++)
            all[i][j] = i == j ? 0 : NONE;
    for (i = 0; i < EDGES; i++)
        all[edges[i][0]][edges[i][1]] = edges[i][2];
    for (k = 0; k < NODES; k++)
        for (i = 0; i < NODES; i++)
            for (j = 0; j < NODES; j++)
                if (all[i][k] + all[k][j] < all[i][j])
                    all[i][j] = all[i][k] + all[k][j];
    for (i = 0; i < NODES; i++) {
        dijkstra(i, cost, before);
        for (j = 0; j < NODES; j++)
            same &= (cost[j] >= NONE && all[i][j] >= NONE) || cost[j] == all[i][j];
        if (i == 0)
            for (j = 0; j < NODES; j++)
                printf("%d ", cost[j] < NONE ? cost[j] : -1);
    }
    printf("\n%d\n", same);
    dijkstra(0, cost, before);
    path(before, 5);
    printf("\n");
    return 0;
}
