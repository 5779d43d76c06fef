/* A binary heap with a comparison of its own, used for an event simulation and for sorting. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct event { int time, robot; char action[8]; };

struct heap {
    struct event *events;
    int count, room;
    int (*before)(const struct event *, const struct event *);
};

static int by_time(const struct event *a, const struct event *b)
{
    return a->time != b->time ? a->time < b->time : a->robot < b->robot;
}

static int by_action(const struct event *a, const struct event *b)
{
    return strcmp(a->action, b->action) < 0;
}

static void push(struct heap *h, struct event e)
{
    if (h->count == h->room) {
        h->room = h->room ? 2 * h->room : 2;
        h->events = realloc(h->events, h->room * sizeof *h->events);
    }
    int i = h->count++;
    for (; i > 0 && h->before(&e, &h->events[(i - 1) / 2]); i = (i - 1) / 2)
        h->events[i] = h->events[(i - 1) / 2];
    h->events[i] = e;
}

static struct event pop(struct heap *h)
{
    struct event first = h->events[0], last = h->events[--h->count];
    int i = 0, child;
    while ((child = 2 * i + 1) < h->count) {
        if (child + 1 < h->count && h->before(&h->events[child + 1], &h->events[child]))
            child++;
        if (!h->before(&h->events[child], &last))
            break;
        h->events[i] = h->events[child];
        i = child;
    }
    if (h->count)
        h->events[i] = last;
    return first;
}

int main(void)
{
    struct heap queue = { .before = by_time }, sorted = { .before = by_action };
    const char *actions[] = { "move", "turn", "sense", "stop" };
    int seen = 0;

    for (int robot = 0; robot < 3; robot++) {
        struct event e = { robot * 2, robot, "start" };
        push(&queue, e);
    }
    while (queue.count && seen < 16) {
        struct event e = pop(&queue);
        printf("%3d robot %d %s\n", e.time, e.robot, e.action);
        push(&sorted, e);
        e.time += 3 + e.robot * 2;
        strcpy(e.action, actions[seen++ % 4]);
        push(&queue, e);
    }
    while (sorted.count)
        printf("%s ", pop(&sorted).action);
    printf("%d\n", queue.count);
    free(queue.events);
    free(sorted.events);
    return 0;
}
