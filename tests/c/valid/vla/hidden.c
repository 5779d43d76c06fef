/* What else may have a variable length: types in casts, sizeof with effects, pointers, K&R. */
#include <stdio.h>
#include <stdarg.h>

static int calls;

static int next(int n)
{
    calls++;
    return n;
}

static int column(matrix, rows, columns, which)
    int rows, columns;
    int matrix[rows][columns];
    int which;
{
    int sum = 0, i;
    for (i = 0; i < rows; i++)
        sum += matrix[i][which];
    return sum;
}

static long long wide(long long n, unsigned char m)
{
    int v[n][m], (*p)[m] = v, *q = v[0];
    long long sum = 0;

    for (int i = 0; i < n * m; i++)
        *q++ = i;
    p += n;
    for (; p-- != v;)
        sum = sum * 3 + (*p)[m - 1];
    p++;
    ++p;
    return sum * 10 + (p - v) + (&p[1] - &v[n - 1]);
}

static int scan(int count, ...)
{
    va_list list;
    int sum = 0;

    va_start(list, count);
    int (*p)[count] = va_arg(list, int (*)[count]);
    for (int i = 0; i < count; i++)
        sum += (*p)[i];
    va_end(list);
    return sum;
}

struct shape { int rows, columns; double *cells; };

static double corner(struct shape *s)
{
    double (*m)[s->columns] = (double (*)[s->columns])s->cells;
    const int n = s->rows;
    double (*view)[n][s->columns] = (void *)m;

    return m[n - 1][s->columns - 1] * 100 + (*view)[0][1] + sizeof *view / sizeof **view;
}

static int recursive(int n)
{
    int v[n], i;

    for (i = 0; i < n; i++)
        v[i] = n - i;
    if (n > 1)
        v[0] += recursive(n - 1);
    return v[0] + v[n - 1];
}

int main(void)
{
    int grid[2][3] = {{1, 2, 3}, {4, 5, 6}}, n = 3;
    double cells[] = {1, 2, 3, 4, 5, 6};
    struct shape shape = {2, 3, cells};
    int (*pointers[2])[n] = {grid, grid + 1};
    int table[next(2)][next(3)];
    static int (*kept)[3];

    printf("%d\n", calls);
    printf("%d %d\n", (int)sizeof(int[next(4)][next(5)]), calls);
    printf("%d %d\n", (int)sizeof table[next(0)], calls);
    printf("%d %d\n", (int)sizeof(char (*)[next(9)]), calls > 5);
    printf("%d\n", column(grid, 2, 3, 1));
    printf("%lld\n", wide(4, 5));
    printf("%d\n", scan(3, &grid[1]));
    printf("%g\n", corner(&shape));
    printf("%d\n", (*pointers[1])[2] + pointers[0][1][1]);
    printf("%d\n", recursive(50));
    int again[n];
    n = 100;
    kept = (int (*)[n])grid == grid ? &grid[1] : 0;
    for (int i = 0; i < 3; i++)
        again[i] = (*kept)[i] * (int)sizeof again;
    printf("%d %d %d\n", again[0], again[1], again[2]);
    printf("%d\n", (n > 3 ? again : table[0])[2]);
    printf("%d %d\n", (int)_Alignof(double[n]), (int)sizeof(*(1 ? &again : 0)));
    return 0;
}
