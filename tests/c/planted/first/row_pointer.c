/* A pointer to a row; the column comes from elsewhere. */
#include <stdio.h>
#include <stdlib.h>
static int grid[3][5];
static int get(int (*row)[5], int column)
{
    return (*row)[column]; // error: out of bounds
}
int main(void)
{
    int i, sum = 0;
    for (i = 0; i < 3; i++)
        sum += get(grid + i, i + PLANT(3, 2));
    printf("%d\n", sum);
    return 0;
}
