/* A local variable is put into a list through a parameter and sorted. */
#include <stdio.h>
#include <stdlib.h>
struct item { int key; double weight; };
static struct item list[3];
static void put(int at, const struct item *it) { list[at] = *it; }
static int by_weight(const void *a, const void *b)
{
    const struct item *x = a, *y = b;
    return x->weight < y->weight ? -1 : 1; // error: uninitialised read
}
int main(void)
{
    struct item one; // origin
    one.key = 4;
    PLANT(, one.weight = 0.5);
    put(0, &one);
    one.weight = 2;
    put(1, &one);
    one.weight = 1;
    put(2, &one);
    qsort(list, 3, sizeof *list, by_weight);
    printf("%d\n", list[0].key);
    return 0;
}
