/* Variable length arrays: sizes at run time, sizeof, two dimensions, parameters. */
#include <stdio.h>

static int sum(int n, int m, int v[n][m])
{
    int i, j, s = 0;

    for (i = 0; i < n; i++)
        for (j = 0; j < m; j++)
            s += v[i][j];
    return s;
}

static int fill(int n)
{
    int v[n], i;

    for (i = 0; i < n; i++)
        v[i] = i * i;
    return v[n - 1] + (int) sizeof v;
}

int main(void)
{
    int n, i, j;

    for (n = 1; n < 5; n++) {
        int grid[n][n + 1];
        for (i = 0; i < n; i++)
            for (j = 0; j <= n; j++)
                grid[i][j] = i * 10 + j;
        printf("%d %d %d\n", sum(n, n + 1, grid), (int) sizeof grid, (int) sizeof grid[0]);
    }
    printf("%d %d\n", fill(3), fill(10));
    return 0;
}
