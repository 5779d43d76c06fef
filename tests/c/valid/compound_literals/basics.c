/* Compound literals are objects with an address (C17 6.5.2.5). */
#include <stdio.h>

struct point { int x, y; };

static int *global = (int[]) { 1, 2, 3 };
static struct point *fixed = &(struct point) { 4, 5 };

static int sum(const int *v, int n)
{
    int s = 0;

    while (n--)
        s += *v++;
    return s;
}

static int manhattan(struct point p) { return p.x + p.y; }
static void move(struct point *p, struct point by) { p->x += by.x; p->y += by.y; }

int main(void)
{
    struct point p = (struct point) { 1, 2 }, *q;
    int i, *v;
    char *s = (char[]) { "writable" };

    p = (struct point) { .y = p.x, .x = p.y };
    printf("%d %d\n", p.x, p.y);
    printf("%d %d\n", sum((int[]) { 10, 20, 30 }, 3), manhattan((struct point) { 7, 8 }));
    q = &(struct point) { p.x * 10 };
    move(q, (struct point) { 1, 1 });
    printf("%d %d\n", q->x, q->y);
    s[0] = 'W';
    printf("%s %d\n", s, (int) sizeof((char[]) { "abc" }));
    for (i = 0; i < 3; i++) {
        v = (int[2]) { i };
        v[1] += v[0] + 1;
        printf("%d %d ", v[0], v[1]);
    }
    printf("\n%d %d %d\n", global[2], fixed->y, ((int[]) { 5, 6, 7 })[1]);
    printf("%d\n", (struct point) { 3, 9 }.y);
    printf("%d\n", (int) { 5 } + 1);
    printf("%s\n", (const char *[]) { "zero", "one", "two" }[2]);
    return 0;
}
