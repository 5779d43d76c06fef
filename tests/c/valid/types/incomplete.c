/* Types that are completed later, or never, if only pointers to them are used. */
#include <stdio.h>

struct never;
struct later;
union shape;
extern int numbers[];
extern struct later global;
typedef struct node list;

static int sum(const struct later *l);
static struct never *nothing(struct never *n) { return n; }
static list *tail(list *l);

struct later { int a, b; };
struct node { int value; list *next; struct node *back; };
union shape { int side; double radius; };

static int sum(const struct later *l) { return l->a + l->b; }
static list *tail(list *l) { return l->next ? tail(l->next) : l; }

struct tree { struct branch { struct tree *left, *right; } in; int n; };
struct a { struct b *to; int n; };
struct b { struct a *to; int n; };

int main(void)
{
    list third = { 3, 0, 0 }, second = { 2, &third, 0 }, first = { 1, &second, 0 };
    struct tree leaf = { { 0, 0 }, 5 }, top = { { &leaf, 0 }, 6 };
    struct a a;
    struct b b = { &a, 8 };
    union shape shape = { 4 };
    struct branch branch = top.in;

    third.back = &first;
    a.to = &b;
    a.n = 9;
    printf("%d %d\n", sum(&global), numbers[2]);
    printf("%d %d\n", nothing(0) == 0, tail(&first)->back->value);
    printf("%d %d\n", branch.left->n, top.in.left->in.right == 0);
    printf("%d %d %d\n", a.to->to->n, b.to->to->n, shape.side);
    return 0;
}

struct later global = { 30, 12 };
int numbers[] = { 1, 2, 3, 4 };
