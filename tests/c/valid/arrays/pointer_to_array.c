/* Pointers to arrays and arrays of pointers. */
#include <stdio.h>

static int matrix[3][4] = { { 1, 2, 3, 4 }, { 5, 6, 7, 8 }, { 9, 10, 11, 12 } };

static int (*row_of(int n))[4]
{
    return &matrix[n];
}

static int *cell_of(int i, int j)
{
    return &matrix[i][j];
}

static int corner(int (*m)[3][4])
{
    return (*m)[2][3];
}

int main(void)
{
    int (*row)[4], *cells[3], **pp, i;
    int (*all)[3][4] = &matrix;
    int *lines[] = { matrix[2], matrix[1], matrix[0] };

    for (row = matrix; row < matrix + 3; row++)
        printf("%d %d\n", (*row)[0], row[0][3]);
    printf("%d\n", (*row_of(1))[2]);
    *cell_of(1, 2) = 70;
    printf("%d %d\n", matrix[1][2], corner(all));
    for (i = 0; i < 3; i++)
        cells[i] = &matrix[i][i];
    for (pp = cells; pp != cells + 3; pp++)
        printf("%d ", **pp);
    printf("\n");
    for (i = 0; i < 3; i++)
        printf("%d ", lines[i][1]);
    printf("\n%d\n", (int) (all[0][1] - all[0][0]));
    printf("%d %d\n", (int) sizeof *row, (int) sizeof *all);
    row = matrix + 2;
    printf("%d %d\n", (int) (row - matrix), row[-1][0]);
    return 0;
}
