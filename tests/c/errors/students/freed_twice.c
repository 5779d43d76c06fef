/* Example: a function frees all nodes of a list, and its caller then frees one of them again. */
#include <stdlib.h>

struct item {
    double weight;
    struct item *next;
};

static void drop(struct item *first)
{
    if (first->next != NULL)
        drop(first->next);
    free(first);
}

int main(void)
{
    struct item *a = calloc(1, sizeof *a), *b = calloc(1, sizeof *b);

    a->next = b;
    drop(a);
    free(b); // error: double free
    return 0;
}
