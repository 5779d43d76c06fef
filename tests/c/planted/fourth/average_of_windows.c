/* Sums of windows on fresh memory. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    static const int samples[] = {3, 5, 8, 13, 21, 34};
    int *sums = PLANT(malloc(3 * sizeof *sums), calloc(3, sizeof *sums));

    for (int i = 0; i < 6; i++)
        sums[i / 2] += samples[i]; // error: uninitialised read
    printf("%d\n", sums[2]);
    free(sums);
    return 0;
}
