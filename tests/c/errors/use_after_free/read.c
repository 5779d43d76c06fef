/* A list is freed while it is walked. */
#include <stdlib.h>

struct node { int value; struct node *next; };

int main(void)
{
    struct node *n, *list = NULL;
    int i;

    for (i = 0; i < 3; i++) {
        n = malloc(sizeof *n);
        n->value = i;
        n->next = list;
        list = n;
    }
    for (n = list; n != NULL; n = n->next) // error: use after free
        free(n);
    return 0;
}
