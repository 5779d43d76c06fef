/* An index is too large for a row, but stays inside the matrix. */
static int grid[4][3];

int main(void)
{
    int column;

    for (column = 0; column <= 3; column++)
        grid[1][column] = 1; // error: out of bounds
    return 0;
}
