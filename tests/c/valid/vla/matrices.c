/* Matrices with computed sizes: parameters, pointers, typedefs, sizeof. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void multiply(int n, int m, int k, double a[n][m], double (*b)[k], double out[static n][k])
{
    int i, j, l;

    for (i = 0; i < n; i++)
        for (j = 0; j < k; j++) {
            double sum = 0;
            for (l = 0; l < m; l++)
                sum += a[i][l] * b[l][j];
            out[i][j] = sum;
        }
}

static void print(int rows, int columns, double matrix[rows][columns]);
static int last(int n, int v[restrict const static n], int (*)[*]);

static double trace(int n, double matrix[][n])
{
    double sum = 0;
    double (*row)[n] = matrix, (*end)[n] = &matrix[n];

    while (row < end) {
        sum += (*row)[row - matrix];
        row++;
    }
    return row - matrix == n && end - 1 == --row ? sum : -1;
}

static void transpose(size_t n, short (*square)[n][n])
{
    short copy[n][n];

    memcpy(copy, *square, sizeof copy);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            (*square)[i][j] = copy[j][i];
}

static int volume(int x, int y, int z)
{
    typedef unsigned char layer[y][z];
    layer block[x], *p = block;
    int i, sum = 0;

    x = y = z = 1;
    memset(block, 1, sizeof block);
    for (p = block + sizeof block / sizeof(layer) - 1; p >= block; p -= 1)
        for (i = 0; i < (int)(sizeof *p / sizeof (*p)[0]); i++)
            sum += (*p)[i][sizeof (*p)[0] - 1] * (i + 1);
    return sum * 1000 + (int)sizeof(layer);
}

int main(void)
{
    int n, m;
    double (*heap)[3];

    for (n = 1; n < 4; n++) {
        double a[n][n + 1], b[n + 1][n], c[n][n];
        for (int i = 0; i < n; i++)
            for (int j = 0; j <= n; j++)
                a[i][j] = b[j][i] = i * 2.5 - j;
        multiply(n, n + 1, n, a, b, c);
        print(n, n, c);
        printf("trace %g of %u bytes\n", trace(n, c), (unsigned)sizeof c);
    }
    m = 3;
    heap = malloc(2 * sizeof *heap);
    for (n = 0; n < 6; n++)
        ((double *)heap)[n] = n + 0.5;
    print(2, m, (double (*)[m])heap);
    free(heap);
    short square[m][m];
    for (n = 0; n < m * m; n++)
        square[n / m][n % m] = n * n;
    transpose(m, &square);
    for (n = 0; n < m; n++)
        printf("%d %d %d\n", square[n][0], square[n][1], *(*(square + n) + 2));
    printf("%d %d\n", volume(2, 3, 4), volume(5, 1, 7));
    printf("%d %d\n", (int)sizeof(int[m++]), m);
    printf("%d\n", last(3, (int[]){7, 8, 9}, 0));
    return 0;
}

static void print(int rows, int columns, double matrix[rows][columns])
{
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            printf("%g%c", matrix[i][j], j < columns - 1 ? ' ' : '\n');
}

static int last(int n, int v[restrict const static n], int (*unused)[n])
{
    return v[n - 1] + (unused == 0);
}
