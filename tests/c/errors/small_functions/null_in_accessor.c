/* The pointer is followed in a function small enough to be inlined. */
#include <stdio.h>

struct node { struct node *next; int number; };

static int number_of(const struct node *node)
{
    return node->number;  // error: null pointer
}

static int sum(const struct node *node, int count)
{
    int total = 0;
    for (; count > 0; count--, node = node->next)
        total += number_of(node);
    return total;
}

int main(void)
{
    struct node last = { 0, 3 }, first = { &last, 4 };
    printf("%d\n", sum(&first, 3));
    return 0;
}
