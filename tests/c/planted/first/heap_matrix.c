/* Rows of a matrix on the heap: the column is too large, but not behind the block. */
#include <stdio.h>
#include <stdlib.h>
struct row { double cell[3]; double norm; };
int main(void)
{
    struct row *rows = calloc(4, sizeof *rows);
    int i, j;
    for (i = 0; i < 4; i++) {
        for (j = 0; j < PLANT(4, 3); j++)
            rows[i].cell[j] = i * j; // error: out of bounds
        rows[i].norm = 1;
    }
    printf("%g\n", rows[2].cell[1]);
    free(rows);
    return 0;
}
