/* An index is computed against another block. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    double *a = calloc(8, sizeof *a), *b = calloc(8, sizeof *b), *at = PLANT(b, a) + 3;
    int index = at - a; // error: unrelated pointers
    printf("%d\n", index > 0);
    free(a);
    free(b);
    return 0;
}
