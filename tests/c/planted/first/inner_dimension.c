/* Rows and columns exchanged. */
#include <stdio.h>
int main(void)
{
    int map[6][4] = {{0}}, x, y, sum = 0;
    for (y = 0; y < PLANT(4, 6); y++)
        for (x = 0; x < PLANT(6, 4); x++)
            map[y][x] = x + y; // error: out of bounds
    for (y = 0; y < 4; y++)
        sum += map[y][3];
    printf("%d\n", sum);
    return 0;
}
