/* Small functions that take and return structs by value: points and rectangles. */
#include <stdio.h>

struct point { int x, y; };
struct box { struct point low, high; };

static struct point make_point(int x, int y)
{
    struct point p;

    p.x = x;
    p.y = y;
    return p;
}

static struct point sum(struct point a, struct point b)
{
    return make_point(a.x + b.x, a.y + b.y);
}

static struct point turned(struct point p)
{
    return make_point(-p.y, p.x);
}

static int inside(struct box b, struct point p)
{
    return b.low.x <= p.x && p.x < b.high.x && b.low.y <= p.y && p.y < b.high.y;
}

static struct box grown(struct box b, struct point p)
{
    if (p.x < b.low.x)
        b.low.x = p.x;
    if (p.y < b.low.y)
        b.low.y = p.y;
    if (p.x >= b.high.x)
        b.high.x = p.x + 1;
    if (p.y >= b.high.y)
        b.high.y = p.y + 1;
    return b;
}

int main(void)
{
    struct point at = { 0, 0 }, step = { 3, 1 };
    struct box room = { { -900, -700 }, { 900, 700 } }, seen = { { 0, 0 }, { 1, 1 } };
    int i, turns = 0;

    for (i = 0; i < 12000000; i++) {
        struct point next = sum(at, step);
        if (inside(room, next)) {
            at = next;
            seen = grown(seen, at);
        } else {
            step = turned(step);
            step.x += turns++ % 2 ? 1 : 0;
            if (step.x > 9)
                step = make_point(step.y % 4 + 1, 2);
        }
    }
    printf("structs %d %d %d %d %d %d\n", at.x, at.y, turns, seen.low.x, seen.high.x, seen.high.y);
    return 0;
}
