/* A realloc that changes nothing. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    long *a = calloc(4, sizeof *a), *b = realloc(a, 4 * sizeof *a);
    b[0] = 5;
    printf("%ld\n", PLANT(a, b)[0]); // error: use after free
    free(b);
    return 0;
}
