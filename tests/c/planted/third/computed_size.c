/* The size of a block depends on the number of robots; the index does on something else. */
#include <stdio.h>
#include <stdlib.h>
static int robots = 3;
int main(void)
{
    int n = robots * 4, i, sum = 0;
    int *cells = calloc(n, sizeof *cells), *more = calloc(100, sizeof *more);
    for (i = 0; i < n; i += PLANT(40, 4)) {
        sum += cells[i]; // error: out of bounds
        if (PLANT(i == 0, 0))
            n = 100;
    }
    printf("%d\n", sum + more[0]);
    free(cells);
    free(more);
    return 0;
}
