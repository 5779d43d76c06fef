/* A board is read by columns, with the bounds exchanged. */
#include <stdio.h>

#define ROWS 5
#define COLUMNS 3

static int board[ROWS][COLUMNS];

int main(void)
{
    int sum = 0;

    for (int y = 0; y < ROWS; y++)
        for (int x = 0; x < COLUMNS; x++)
            board[y][x] = x + y;
    for (int x = 0; x < PLANT(ROWS, COLUMNS); x++)
        sum += board[2][x]; // error: out of bounds
    printf("%d\n", sum);
    return 0;
}
