/* A row too far in a two-dimensional array. */
static double grid[4][5];

int main(void)
{
    volatile int row = 4;

    grid[row][0] = 1; // error: out of bounds
    return 0;
}
