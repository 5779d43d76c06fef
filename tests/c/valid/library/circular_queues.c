/* Circular queues, joined queues, and loops that remove; __P as in sources of BSD. */
#include <stdio.h>
#include <stdlib.h>
#include <sys/queue.h>
#ifndef LIST_FOREACH_SAFE
#define LIST_FOREACH_SAFE(e, h, f, n) \
    for ((e) = LIST_FIRST(h); (e) && ((n) = LIST_NEXT(e, f), 1); (e) = (n))
#define TAILQ_FOREACH_SAFE(e, h, f, n) \
    for ((e) = TAILQ_FIRST(h); (e) && ((n) = TAILQ_NEXT(e, f), 1); (e) = (n))
#endif

struct event {
    CIRCLEQ_ENTRY(event) circle;
    TAILQ_ENTRY(event) tail;
    LIST_ENTRY(event) list;
    STAILQ_ENTRY(event) single;
    int time;
};
CIRCLEQ_HEAD(circle, event) circle = CIRCLEQ_HEAD_INITIALIZER(circle), empty;
TAILQ_HEAD(tail, event) tail = TAILQ_HEAD_INITIALIZER(tail), rest = TAILQ_HEAD_INITIALIZER(rest);
LIST_HEAD(list, event) list = LIST_HEAD_INITIALIZER(list);
STAILQ_HEAD(single, event) one = STAILQ_HEAD_INITIALIZER(one), two = STAILQ_HEAD_INITIALIZER(two);

static struct event *make __P((int time));
static void show __P((const char *title));

static struct event *make(int time) {
    struct event *made = malloc(sizeof *made);
    made->time = time;
    return made;
}

static void show(const char *title) {
    struct event *each;
    printf("%s:", title);
    CIRCLEQ_FOREACH(each, &circle, circle) printf(" %d", each->time);
    printf(" |");
    CIRCLEQ_FOREACH_REVERSE(each, &circle, circle) printf(" %d", each->time);
    putchar('\n');
}

int main(void) {
    struct event *each, *next, *middle;
    CIRCLEQ_INIT(&empty);
    printf("%d %d\n", CIRCLEQ_EMPTY(&empty), CIRCLEQ_EMPTY(&circle));
    for (int i = 1; i <= 3; i++) {
        each = make(i);
        CIRCLEQ_INSERT_TAIL(&circle, each, circle);
    }
    each = make(0);
    CIRCLEQ_INSERT_HEAD(&circle, each, circle);
    middle = CIRCLEQ_NEXT(CIRCLEQ_FIRST(&circle), circle);
    each = make(15);
    CIRCLEQ_INSERT_AFTER(&circle, middle, each, circle);
    each = make(5);
    CIRCLEQ_INSERT_BEFORE(&circle, middle, each, circle);
    each = make(99);
    next = CIRCLEQ_LAST(&circle);
    CIRCLEQ_INSERT_AFTER(&circle, next, each, circle);
    each = make(-9);
    next = CIRCLEQ_FIRST(&circle);
    CIRCLEQ_INSERT_BEFORE(&circle, next, each, circle);
    show("all");
    next = CIRCLEQ_LAST(&circle);
    each = CIRCLEQ_FIRST(&circle);
    printf("%d", CIRCLEQ_LOOP_NEXT(&circle, next, circle)->time);
    printf(" %d\n", CIRCLEQ_LOOP_PREV(&circle, each, circle)->time);
    CIRCLEQ_REMOVE(&circle, middle, circle);
    next = CIRCLEQ_FIRST(&circle);
    CIRCLEQ_REMOVE(&circle, next, circle);
    next = CIRCLEQ_LAST(&circle);
    CIRCLEQ_REMOVE(&circle, next, circle);
    show("fewer");
    for (int i = 0; i < 4; i++) {
        each = make(i);
        if (i < 2) TAILQ_INSERT_TAIL(&tail, each, tail);
        else TAILQ_INSERT_TAIL(&rest, each, tail);
        LIST_INSERT_HEAD(&list, each, list);
        if (i % 2) STAILQ_INSERT_TAIL(&one, each, single);
        else STAILQ_INSERT_TAIL(&two, each, single);
    }
    TAILQ_CONCAT(&tail, &rest, tail);
    STAILQ_CONCAT(&one, &two);
    TAILQ_FOREACH_REVERSE(each, &tail, tail, tail) printf("%d ", each->time);
    STAILQ_FOREACH(each, &one, single) printf("%d ", each->time);
    printf("%d %d\n", TAILQ_EMPTY(&rest), STAILQ_EMPTY(&two));
    TAILQ_FOREACH_SAFE(each, &tail, tail, next) TAILQ_REMOVE(&tail, each, tail);
    LIST_FOREACH_SAFE(each, &list, list, next) {
        LIST_REMOVE(each, list);
        free(each);
    }
    printf("%d %d\n", TAILQ_EMPTY(&tail), LIST_EMPTY(&list));
    return 0;
}
