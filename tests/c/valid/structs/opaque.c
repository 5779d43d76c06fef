/* Incomplete struct types, completed later; tags in separate scopes. */
#include <stdio.h>
#include <stdlib.h>

struct queue;
typedef struct queue Queue;
extern Queue *queue_new(int capacity);
extern int queue_put(Queue *q, int value);
extern int queue_get(Queue *q);

struct first { struct second *other; int n; };
struct second { struct first *other; int n; };

static int use(void)
{
    Queue *q = queue_new(3);
    int i, sum = 0;

    for (i = 1; i < 6; i++)
        printf("%d", queue_put(q, i * i));
    printf("\n");
    for (i = 0; i < 3; i++)
        sum = sum * 10 + queue_get(q);
    free(q);
    return sum;
}

struct queue { int head, count, capacity; int items[1]; };

Queue *queue_new(int capacity)
{
    Queue *q = malloc(sizeof *q + (capacity - 1) * sizeof q->items[0]);

    q->head = q->count = 0;
    q->capacity = capacity;
    return q;
}

int queue_put(Queue *q, int value)
{
    if (q->count == q->capacity)
        return 0;
    *(q->items + (q->head + q->count++) % q->capacity) = value;
    return 1;
}

int queue_get(Queue *q)
{
    int value = *(q->items + q->head);

    q->head = (q->head + 1) % q->capacity;
    q->count--;
    return value;
}

int main(void)
{
    struct first a;
    struct second b = { &a, 2 };

    a.other = &b;
    a.n = 1;
    printf("%d\n", use());
    printf("%d %d\n", a.other->n, b.other->other->other->n);
    {
        struct first { char c; } inner = { 'x' };
        printf("%c %d\n", inner.c, (int) sizeof(struct first));
    }
    printf("%d\n", (int) sizeof(struct first));
    return 0;
}
