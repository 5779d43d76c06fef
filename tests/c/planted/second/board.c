/* The neighbours of a field at the edge. */
#include <stdio.h>
static char board[8][8];
static int around(int x, int y)
{
    int dx, n = 0;
    for (dx = -1; dx <= 1; dx++)
        if (PLANT(1, x + dx >= 0 && x + dx < 8))
            n += board[y][x + dx]; // error: out of bounds
    return n;
}
int main(void) { board[3][0] = 1; printf("%d\n", around(1, 3) + around(0, 3)); return 0; }
