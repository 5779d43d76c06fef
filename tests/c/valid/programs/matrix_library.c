/* A small matrix library: allocation, product, transpose, determinant, inverse, solving. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    int rows, columns;
    double *at;
} Matrix;

#define AT(m, r, c) ((m)->at[(r) * (m)->columns + (c)])

static Matrix *matrix_new(int rows, int columns)
{
    Matrix *m = malloc(sizeof *m);
    m->rows = rows;
    m->columns = columns;
    m->at = calloc((size_t) rows * columns, sizeof *m->at);
    return m;
}

static void matrix_free(Matrix *m)
{
    if (m) {
        free(m->at);
        free(m);
    }
}

static Matrix *matrix_of(int rows, int columns, const double *values)
{
    Matrix *m = matrix_new(rows, columns);
    memcpy(m->at, values, sizeof *values * rows * columns);
    return m;
}

static Matrix *identity(int n)
{
    Matrix *m = matrix_new(n, n);
    for (int i = 0; i < n; i++)
        AT(m, i, i) = 1;
    return m;
}

static Matrix *product(const Matrix *a, const Matrix *b)
{
    if (a->columns != b->rows)
        return NULL;
    Matrix *m = matrix_new(a->rows, b->columns);
    for (int i = 0; i < a->rows; i++)
        for (int j = 0; j < b->columns; j++)
            for (int k = 0; k < a->columns; k++)
                AT(m, i, j) += AT(a, i, k) * AT(b, k, j);
    return m;
}

static Matrix *transpose(const Matrix *a)
{
    Matrix *m = matrix_new(a->columns, a->rows);
    for (int i = 0; i < a->rows; i++)
        for (int j = 0; j < a->columns; j++)
            AT(m, j, i) = AT(a, i, j);
    return m;
}

static void swap_rows(Matrix *m, int a, int b)
{
    for (int j = 0; a != b && j < m->columns; j++) {
        double t = AT(m, a, j);
        AT(m, a, j) = AT(m, b, j);
        AT(m, b, j) = t;
    }
}

/* Gauss-Jordan with row exchanges; gives the determinant, turns `right` into the solution. */
static double eliminate(const Matrix *given, Matrix *right)
{
    Matrix *a = matrix_of(given->rows, given->columns, given->at);
    int n = a->rows;
    double determinant = 1;

    for (int k = 0; k < n && determinant != 0; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(AT(a, i, k)) > fabs(AT(a, pivot, k)))
                pivot = i;
        if (pivot != k)
            determinant = -determinant;
        swap_rows(a, k, pivot);
        swap_rows(right, k, pivot);
        double head = AT(a, k, k);
        determinant *= head;
        if (head == 0)
            break;
        for (int j = 0; j < n; j++)
            AT(a, k, j) /= head;
        for (int j = 0; j < right->columns; j++)
            AT(right, k, j) /= head;
        for (int i = 0; i < n; i++) {
            double factor = AT(a, i, k);
            if (i == k)
                continue;
            for (int j = 0; j < n; j++)
                AT(a, i, j) -= factor * AT(a, k, j);
            for (int j = 0; j < right->columns; j++)
                AT(right, i, j) -= factor * AT(right, k, j);
        }
    }
    matrix_free(a);
    return determinant;
}

static void print(const char *name, const Matrix *m)
{
    printf("%s:\n", name);
    for (int i = 0; i < m->rows; i++)
        for (int j = 0; j < m->columns; j++)
            printf("%8.3f%c", AT(m, i, j), j == m->columns - 1 ? '\n' : ' ');
}

int main(void)
{
    static const double values[] = { 2, 1, -1, -3, -1, 2, -2, 1, 2 }, sides[] = { 8, -11, -3 };
    Matrix *a = matrix_of(3, 3, values), *b = matrix_of(3, 1, sides), *inverse = identity(3);

    print("a", a);
    printf("determinant %.6f\n", eliminate(a, inverse));
    print("inverse", inverse);
    Matrix *one = product(a, inverse);
    print("a times inverse", one);
    eliminate(a, b);
    print("solution", b);
    Matrix *t = transpose(b), *square = product(t, b);
    print("length squared", square);
    printf("%d\n", product(a, t) == NULL);
    Matrix *list[] = { a, b, inverse, one, t, square };
    for (unsigned i = 0; i < sizeof list / sizeof *list; i++)
        matrix_free(list[i]);
    return 0;
}
