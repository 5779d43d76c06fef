/* Arrays of two and three dimensions lie row by row. */
#include <stdio.h>
#include <string.h>

#define ROWS 4
#define COLUMNS 5

static int grid[ROWS][COLUMNS];
static short cube[2][3][4];

static void transpose(int from[ROWS][COLUMNS], int to[COLUMNS][ROWS])
{
    int i, j;

    for (i = 0; i < ROWS; i++)
        for (j = 0; j < COLUMNS; j++)
            to[j][i] = from[i][j];
}

static int row_sum(int *row, int n)
{
    int sum = 0;

    while (n--)
        sum += *row++;
    return sum;
}

int main(void)
{
    int turned[COLUMNS][ROWS], i, j, k, *flat;
    char names[3][8] = { "scout", "nomad", "xr" };

    for (i = 0; i < ROWS; i++)
        for (j = 0; j < COLUMNS; j++)
            grid[i][j] = i * 10 + j;
    transpose(grid, turned);
    for (i = 0; i < COLUMNS; i++) {
        for (j = 0; j < ROWS; j++)
            printf("%3d", turned[i][j]);
        printf("  sum %d\n", row_sum(turned[i], ROWS));
    }
    flat = &grid[0][0];
    printf("%d %d %d\n", flat[7], grid[2][-1 + 1], *(*(grid + 3) + 2));
    for (i = k = 0; i < 2; i++)
        for (j = 0; j < 3; j++) {
            int n;
            for (n = 0; n < 4; n++)
                cube[i][j][n] = k++;
        }
    printf("%d %d %d\n", cube[1][2][3], (&cube[0][0][0])[13], (*cube[1])[2]);
    printf("%u %u %u\n", (unsigned) sizeof cube, (unsigned) sizeof cube[0],
           (unsigned) sizeof cube[0][0]);
    memset(cube[0], 0, sizeof cube[0]);
    printf("%d %d\n", cube[0][2][3], cube[1][0][0]);
    strcpy(names[2], names[0]);
    names[1][0] = 'N';
    printf("%s %s %s %c\n", names[0], names[1], names[2], names[0][4]);
    return 0;
}
