/* An array of structs is sorted, and a member was never set. */
#include <stdio.h>
#include <stdlib.h>
struct entry { int key; int weight; };
static int by_key(const void *a, const void *b)
{
    return ((const struct entry *)a)->key - ((const struct entry *)b)->key;
}
int main(void)
{
    struct entry e[5];
    int i, sum = 0;
    for (i = 0; i < 5; i++) {
        e[i].key = (i * 3) % 5;
        if (i != PLANT(2, 9))
            e[i].weight = i;
    }
    qsort(e, 5, sizeof e[0], by_key);
    for (i = 0; i < 5; i++)
        sum += e[i].weight; // error: uninitialised read
    printf("%d\n", sum);
    return 0;
}
