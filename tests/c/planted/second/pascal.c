/* A triangle in a square: one row too many. */
#include <stdio.h>
int main(void)
{
    long t[5][5] = {{1}};
    int i, j;
    for (i = 1; i < PLANT(6, 5); i++)
        for (j = 0; j < 5; j++)
            t[i][j] = t[i - 1][j] + (j ? t[i - 1][j - 1] : 0); // error: out of bounds
    printf("%ld\n", t[4][2]);
    return 0;
}
