/* Rows of a matrix are freed, and the matrix is read once more. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    double **rows = malloc(3 * sizeof *rows);
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        rows[i] = calloc(3, sizeof **rows);
        rows[i][i] = i + 1;
    }
    for (int i = 0; i < 3; i++) {
        PLANT(free(rows[i]);,)
        sum += rows[i][i]; // error: use after free
        PLANT(, free(rows[i]);)
    }
    free(rows);
    printf("%g\n", sum);
    return 0;
}
