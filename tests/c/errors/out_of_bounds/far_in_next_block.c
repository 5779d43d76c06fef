/* The index is right for another block, which is larger. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    int i, n = 4, total = 0;
    int *small, *large = calloc(100, sizeof *large);

    for (i = 0; i < 3; i++) {
        small = malloc(n * sizeof *small);
        large = realloc(large, 400);
        small[0] = i;
        total += small[0];
        if (i == 1)
            small[i + 24] = 7; // error: out of bounds
        free(small);
    }
    printf("%d %d\n", total, large[0]);
    free(large);
    return 0;
}
