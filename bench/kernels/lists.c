/* Linked structs from malloc: lists built, reversed, merge-sorted, and freed; structs by value. */
#include <stdio.h>
#include <stdlib.h>

struct point { int x, y; };
struct node { struct point at; unsigned key; struct node *next; };

static struct point add(struct point a, struct point b)
{
    a.x += b.x;
    a.y ^= b.y;
    return a;
}

static struct node *merge(struct node *a, struct node *b)
{
    struct node head, *last = &head;

    while (a && b) {
        if (a->key <= b->key) {
            last->next = a;
            a = a->next;
        } else {
            last->next = b;
            b = b->next;
        }
        last = last->next;
    }
    last->next = a ? a : b;
    return head.next;
}

static struct node *sort(struct node *list)
{
    struct node *slow = list, *fast, *half;

    if (!list || !list->next)
        return list;
    for (fast = list->next; fast && fast->next; fast = fast->next->next)
        slow = slow->next;
    half = slow->next;
    slow->next = NULL;
    return merge(sort(list), sort(half));
}

int main(void)
{
    unsigned seed = 3, sum = 0;
    int round, i;

    for (round = 0; round < 12; round++) {
        struct node *list = NULL, *n, *after;
        struct point total = { 0, 0 };
        for (i = 0; i < 20000; i++) {
            n = malloc(sizeof *n);
            seed = seed * 1664525u + 1013904223u;
            n->key = seed >> 8;
            n->at.x = i;
            n->at.y = seed >> 16;
            n->next = list;
            list = n;
        }
        list = sort(list);
        for (n = list; n; n = after) {
            after = n->next;
            total = add(total, n->at);
            sum = sum * 3 + n->key;
            free(n);
        }
        sum += total.x + total.y;
    }
    printf("lists %u\n", sum);
    return 0;
}
