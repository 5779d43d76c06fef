/* Eight queens by backtracking, and the knight's tour count of a small board. */
#include <stdio.h>

static int column[8], up[15], down[15], place[8], solutions;

static void try_row(int row, int n)
{
    int c;

    if (row == n) {
        if (solutions++ == 0)
            for (c = 0; c < n; c++)
                printf("%d ", place[c]);
        return;
    }
    for (c = 0; c < n; c++) {
        if (column[c] || up[row + c] || down[row - c + n - 1])
            continue;
        column[c] = up[row + c] = down[row - c + n - 1] = 1;
        place[row] = c;
        try_row(row + 1, n);
        column[c] = up[row + c] = down[row - c + n - 1] = 0;
    }
}

static int board[5][5];

static int tour(int i, int j, int n)
{
    static const int d[8][2] = { { 1, 2 }, { 2, 1 }, { 2, -1 }, { 1, -2 }, { -1, -2 }, { -2, -1 },
                                 { -2, 1 }, { -1, 2 } };
    int k;

    if (i < 0 || i > 4 || j < 0 || j > 4 || board[i][j])
        return 0;
    board[i][j] = n;
    if (n == 25)
        return 1;
    for (k = 0; k < 8; k++)
        if (tour(i + d[k][0], j + d[k][1], n + 1))
            return 1;
    board[i][j] = 0;
    return 0;
}

int main(void)
{
    int n, i, j;

    for (n = 1; n <= 6; n++) {
        solutions = 0;
        try_row(0, n);
        printf("%d: %d\n", n, solutions);
    }
    if (tour(0, 0, 1))
        for (i = 0; i < 5; i++)
            for (j = 0; j < 5; j++)
                printf("%3d%s", board[i][j], j == 4 ? "\n" : "");
    return 0;
}
