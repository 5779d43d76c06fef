/* Bits are set in a word that was never cleared. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    unsigned *mask = malloc(4 * sizeof *mask);
    int i;
    PLANT(, mask[0] = 0; mask[1] = 0);
    for (i = 0; i < 40; i += 7)
        mask[i / 32] |= 1u << i % 32; // error: uninitialised read
    printf("%u\n", mask[0]);
    free(mask);
    return 0;
}
