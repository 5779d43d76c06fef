/* Example: the pointer to the next node is in the node that was just freed. */
#include <stdlib.h>

struct node {
    int x, y;
    struct node *next;
};

static struct node *path;

static void add(int x, int y)
{
    struct node *n = malloc(sizeof *n);

    n->x = x;
    n->y = y;
    n->next = path;
    path = n;
}

static void clear(void)
{
    struct node *n;

    for (n = path; n != NULL; n = n->next) // error: use after free
        free(n);
    path = NULL;
}

int main(void)
{
    add(1, 2);
    add(3, 4);
    clear();
    return 0;
}
