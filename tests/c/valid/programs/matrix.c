/* Matrix inversion by Gauss-Jordan with pivoting, determinants, solving equations. */
#include <stdio.h>
#include <math.h>

#define N 4

static double determinant(double m[N][N], int n)
{
    double d = 1;
    int i, j, k;

    for (k = 0; k < n; k++) {
        int best = k;
        for (i = k + 1; i < n; i++)
            if (fabs(m[i][k]) > fabs(m[best][k]))
                best = i;
        if (m[best][k] == 0)
            return 0;
        if (best != k) {
            for (j = 0; j < n; j++) {
                double t = m[k][j];
                m[k][j] = m[best][j];
                m[best][j] = t;
            }
            d = -d;
        }
        d *= m[k][k];
        for (i = k + 1; i < n; i++) {
            double f = m[i][k] / m[k][k];
            for (j = k; j < n; j++)
                m[i][j] -= f * m[k][j];
        }
    }
    return d;
}

static int invert(double a[N][N], double out[N][N])
{
    double m[N][2 * N];
    int i, j, k;

    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            m[i][j] = a[i][j];
            m[i][N + j] = i == j;
        }
    for (k = 0; k < N; k++) {
        int best = k;
        for (i = k; i < N; i++)
            if (fabs(m[i][k]) > fabs(m[best][k]))
                best = i;
        if (fabs(m[best][k]) < 1e-12)
            return 0;
        for (j = 0; j < 2 * N; j++) {
            double t = m[k][j];
            m[k][j] = m[best][j];
            m[best][j] = t;
        }
        for (i = 0; i < N; i++) {
            double f = i == k ? 0 : m[i][k] / m[k][k];
            for (j = 0; j < 2 * N; j++)
                m[i][j] -= f * m[k][j];
        }
    }
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            out[i][j] = m[i][N + j] / m[i][i];
    return 1;
}

int main(void)
{
    double a[N][N] = { { 2, 1, 0, 3 }, { 0, 4, 1, 1 }, { 5, 0, 2, 2 }, { 1, 1, 1, 1 } };
    double inverse[N][N], copy[N][N], product;
    int i, j, k, ok = 1;

    printf("%d\n", invert(a, inverse));
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            printf("%9.5f%s", inverse[i][j], j == N - 1 ? "\n" : "");
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            for (product = k = 0; k < N; k++)
                product += a[i][k] * inverse[k][j];
            ok &= fabs(product - (i == j)) < 1e-9;
            copy[i][j] = a[i][j];
        }
    printf("%d %.6f\n", ok, determinant(copy, N));
    for (j = 0; j < N; j++)
        a[3][j] = a[0][j] + a[1][j];
    printf("%d\n", invert(a, inverse));
    return 0;
}
