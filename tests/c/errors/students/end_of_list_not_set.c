/* The last node of a list must say so. */
#include <stdio.h>
#include <stdlib.h>

struct node {
    int value;
    struct node *next;
};

static int length(const struct node *n)
{
    int count = 0;

    while (n != NULL) {
        count++;
        n = n->next; // error: uninitialised read
    }
    return count;
}

int main(void)
{
    struct node *first = malloc(sizeof *first), *second = malloc(sizeof *second);

    first->value = 1;
    first->next = second;
    second->value = 2;
    printf("%d\n", length(first));
    return 0;
}
