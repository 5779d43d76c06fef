/* Nodes of a pool: the last has no successor. */
#include <stdio.h>

struct node {
    struct node *next;
    int value;
};

static struct node pool[8], other[8];

static void chain(struct node *nodes, int count)
{
    for (int i = 0; i < count; i++) {
        nodes[i].value = i;
        nodes[i].next = &nodes[i + 1];
    }
    PLANT(, nodes[count - 1].next = NULL;)
}

int main(void)
{
    int sum = 0;

    chain(other, 4);
    other[4].value = -1;
    chain(pool, 8);
    for (struct node *at = pool; at; at = at->next)
        sum += at->value; // error: out of bounds
    printf("%d\n", sum);
    return 0;
}
