/* Matrix product through row pointers from malloc; the size is not known to the compiler. */
#include <stdio.h>
#include <stdlib.h>

static double **new_matrix(int rows, int columns)
{
    double **m = malloc(rows * sizeof *m);
    int i;

    m[0] = malloc(rows * columns * sizeof **m);
    for (i = 1; i < rows; i++)
        m[i] = m[0] + i * columns;
    return m;
}

static void multiply(double **c, double **a, double **b, int n)
{
    int i, j, k;

    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            double sum = 0;
            for (k = 0; k < n; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}

int main(void)
{
    int n = 160, i, j, round;
    double **a = new_matrix(n, n), **b = new_matrix(n, n), **c = new_matrix(n, n), **t;
    double trace = 0;

    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            a[i][j] = (i * 7 + j * 3) % 11 / 64.0;
            b[i][j] = (i + j * 5) % 13 / 64.0;
        }
    for (round = 0; round < 14; round++) {
        multiply(c, a, b, n);
        t = a;
        a = c;
        c = t;
    }
    for (i = 0; i < n; i++)
        trace += a[i][i];
    printf("matrix_pointers %.9e\n", trace);
    return 0;
}
