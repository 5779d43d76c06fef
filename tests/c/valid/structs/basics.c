/* Members, nesting, pointers to members, assignment and self reference. */
#include <stdio.h>
#include <string.h>

struct point { int x, y; };
struct box { struct point low, high; char label[6]; struct box *next; };

static int area(struct box *b)
{
    return (b->high.x - b->low.x) * (b->high.y - b->low.y);
}

static void grow(struct box *b, int by)
{
    b->low.x -= by;
    b->low.y -= by;
    b->high.x += by;
    b->high.y += by;
}

int main(void)
{
    struct box a = { { 1, 2 }, { 5, 8 }, "first", 0 }, b;
    struct point *corner = &a.high, origin = { 0, 0 };
    int *py = &a.low.y;

    b = a;
    b.next = &a;
    strcpy(b.label, "two");
    grow(&b, 1);
    printf("%d %d %s %s\n", area(&a), area(&b), a.label, b.next->label);
    corner->x = 11;
    *py = 0;
    printf("%d %d %d\n", area(&a), a.high.x, (*corner).y);
    a.low = origin;
    a.high = b.low;
    printf("%d %d %d %d\n", a.low.x, a.low.y, a.high.x, a.high.y);
    b.next->next = &b;
    printf("%s %s\n", b.next->next->label, b.next->next->next->label);
    (&b)->low.x++;
    printf("%d\n", (&(&b)->low)->x);
    printf("%d %d\n", b.next == &a, &b.low == (struct point *) &b);
    return 0;
}
