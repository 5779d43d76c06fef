/* A block that was never filled is copied to another that grows. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(void)
{
    int *first = malloc(6 * sizeof *first), *copy; // origin
    first[0] = 1;
    PLANT(, first[1] = 2);
    copy = calloc(10, sizeof *copy);
    memcpy(copy, first, 2 * sizeof *first);
    free(first);
    if (copy[1] > 0) // error: uninitialised read
        puts("set");
    free(copy);
    return 0;
}
