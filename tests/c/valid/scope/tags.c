/* struct, union and enum tags have scopes; a bare tag declares anew. */
#include <stdio.h>

struct node { int a; };
struct list { struct item *first; };
struct item { struct list *owner; int n; };

static int outer(struct node *n) { return n->a; }

int main(void)
{
    struct node n = { 1 };
    struct list l;
    struct item i = { &l, 8 };

    l.first = &i;
    {
        struct node;
        struct pair { struct node *p; };
        struct node { double d, e; } m = { 2.5, 3.5 };
        struct pair q = { &m };
        printf("%g %d\n", q.p->e, (int) sizeof(struct node));
    }
    {
        union node { char c[3]; short s; } u = { "ab" };
        printf("%c %d\n", u.c[1], (int) sizeof u);
    }
    {
        enum node { NONE, SOME } e = SOME;
        int node = e + 5;
        printf("%d\n", node);
    }
    printf("%d %d %d\n", outer(&n), (int) sizeof(struct node), l.first->owner->first->n);
    return 0;
}
