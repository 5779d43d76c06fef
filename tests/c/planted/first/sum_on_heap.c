/* Sums are added up in memory that is not cleared. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    int i, *sum = PLANT(malloc(8 * sizeof *sum), calloc(8, sizeof *sum));
    for (i = 0; i < 32; i++)
        sum[i % 8] += i; // error: uninitialised read
    printf("%d\n", sum[3]);
    free(sum);
    return 0;
}
