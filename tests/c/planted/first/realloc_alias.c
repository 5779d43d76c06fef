/* A pointer into a block that has grown. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    int *list = malloc(4 * sizeof *list), *first = list;
    list[0] = 7;
    list = realloc(list, 8 * sizeof *list);
    first = PLANT(first, list);
    printf("%d\n", *first); // error: use after free
    free(list);
    return 0;
}
