/* Index arithmetic: spiral walk, magic squares, rotation in place, Pascal's triangle. */
#include <stdio.h>

#define N 5

static void spiral(int m[N][N])
{
    int di[] = { 0, 1, 0, -1 }, dj[] = { 1, 0, -1, 0 };
    int i = 0, j = 0, d = 0, n;

    for (n = 1; n <= N * N; n++) {
        int ni, nj;
        m[i][j] = n;
        ni = i + di[d];
        nj = j + dj[d];
        if (ni < 0 || ni >= N || nj < 0 || nj >= N || m[ni][nj])
            d = (d + 1) % 4;
        if (n == N * N)
            break;
        i += di[d];
        j += dj[d];
    }
}

static void rotate(int m[][N])
{
    int i, j, t;

    for (i = 0; i < N / 2; i++)
        for (j = i; j < N - 1 - i; j++) {
            t = m[i][j];
            m[i][j] = m[N - 1 - j][i];
            m[N - 1 - j][i] = m[N - 1 - i][N - 1 - j];
            m[N - 1 - i][N - 1 - j] = m[j][N - 1 - i];
            m[j][N - 1 - i] = t;
        }
}

static void print(int m[][N])
{
    int i, j;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            printf("%3d%s", m[i][j], j == N - 1 ? "\n" : "");
}

int main(void)
{
    int m[N][N] = { { 0 } }, magic[N][N] = { { 0 } }, row[12] = { 1 };
    int i, j, n;

    spiral(m);
    print(m);
    rotate(m);
    print(m);
    for (n = 1, i = 0, j = N / 2; n <= N * N; n++) {
        magic[i][j] = n;
        if (n % N == 0)
            i = (i + 1) % N;
        else
            i = (i + N - 1) % N, j = (j + 1) % N;
    }
    print(magic);
    for (n = 0; n < 10; n++) {
        for (i = n; i > 0; i--)
            row[i] += row[i - 1];
        for (i = 0; i <= n; i++)
            printf("%d ", row[i]);
        printf("\n");
    }
    return 0;
}
