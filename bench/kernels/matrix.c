/* Product of two matrices of doubles. */
#include <stdio.h>

#define N 160

static double a[N][N], b[N][N], c[N][N];

static void multiply(void)
{
    int i, j, k;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            double sum = 0;
            for (k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}

int main(void)
{
    int i, j, round;
    double trace = 0;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            a[i][j] = (i * 3 + j) % 7 - 3;
            b[i][j] = (i + j * 5) % 11 - 5;
        }
    for (round = 0; round < 12; round++) {
        multiply();
        for (i = 0; i < N; i++) {
            trace += c[i][i];
            a[i][round] = c[round][i] / 1000;
        }
    }
    printf("matrix %.6f\n", trace);
    return 0;
}
