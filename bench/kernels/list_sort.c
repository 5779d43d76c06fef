/* Insertion and bottom-up merge sort of a linked list whose nodes lie in one array. */
#include <stdio.h>

#define NODES 8192

struct node {
    struct node *next;
    int key;
    int payload[4];
};

static struct node nodes[NODES];

static struct node *merge(struct node *a, struct node *b)
{
    struct node *first = NULL, **link = &first;

    while (a && b)
        if (b->key < a->key) {
            *link = b;
            link = &b->next;
            b = b->next;
        } else {
            *link = a;
            link = &a->next;
            a = a->next;
        }
    *link = a ? a : b;
    return first;
}

static struct node *sort(struct node *list)
{
    struct node *runs[32] = { 0 }, *one;
    int i;

    while (list) {
        one = list;
        list = list->next;
        one->next = NULL;
        for (i = 0; runs[i]; i++) {
            one = merge(runs[i], one);
            runs[i] = NULL;
        }
        runs[i] = one;
    }
    one = NULL;
    for (i = 0; i < 32; i++)
        if (runs[i])
            one = merge(runs[i], one);
    return one;
}

static struct node *insert(struct node *list, struct node *n)
{
    struct node **link = &list;

    while (*link && (*link)->key < n->key)
        link = &(*link)->next;
    n->next = *link;
    *link = n;
    return list;
}

int main(void)
{
    unsigned seed = 1, sum = 0;
    int round, i;

    for (round = 0; round < 30; round++) {
        struct node *list = NULL, *n;
        for (i = 0; i < NODES; i++) {
            seed = seed * 1103515245u + 12345u;
            nodes[i].key = seed >> 12;
            nodes[i].payload[i & 3] = i;
            nodes[i].next = list;
            list = &nodes[i];
        }
        for (n = sort(list); n; n = n->next)
            sum = sum * 5 + n->key;
        list = NULL;
        for (i = 0; i < 700; i++)
            list = insert(list, &nodes[i * 11]);
        for (n = list; n; n = n->next)
            sum = sum * 7 + n->payload[0];
    }
    printf("list_sort %u\n", sum);
    return 0;
}
