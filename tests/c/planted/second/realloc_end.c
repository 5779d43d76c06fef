/* A pointer to where the next number goes, kept over a realloc. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    int *list = malloc(sizeof *list), *next = list;
    *next++ = 1;
    list = realloc(list, 3 * sizeof *list);
    next = PLANT(next, list + 1);
    next[-1] = 2; // error: use after free
    printf("%d\n", list[0] > 0);
    free(list);
    return 0;
}
