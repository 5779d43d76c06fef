/* Example: access to a struct member through a null pointer; the address is small, but not null. */
#include <stdio.h>

struct node {
    char name[40];
    double weight;
    struct node *next;
};

static double total(const struct node *n)
{
    return n->weight + n->next->weight; // error: null pointer
}

int main(void)
{
    struct node b = { "b", 2.0, NULL }, a = { "a", 1.0, &b };

    printf("%g\n", total(&a));
    printf("%g\n", total(&b));
    return 0;
}
