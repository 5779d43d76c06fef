/* The same object through several pointers: every write is seen by every read. */
#include <stdio.h>

static int cell;

static void add_both(int *a, int *b)
{
    *a += 1;
    *b += *a;
    *a += *b;
}

static int through_global(int *p)
{
    cell = 1;
    *p = 2;
    return cell;
}

static void scale(double *to, const double *from, double *factor, int n)
{
    int i;

    for (i = 0; i < n; i++)
        to[i] = from[i] * *factor;
}

int main(void)
{
    int x = 5, y = 7, *p = &x, *q = &x;
    double v[] = { 2, 3, 4 };
    struct { int a, b; } s = { 1, 2 };
    int *inside = &s.b;

    *p = 8;
    printf("%d %d\n", *q, x);
    x = 3;
    printf("%d\n", *p);
    add_both(&x, &y);
    printf("%d %d\n", x, y);
    add_both(&x, &x);
    printf("%d\n", x);
    printf("%d %d\n", through_global(&x), through_global(&cell));
    scale(v, v, &v[0], 3);
    printf("%g %g %g\n", v[0], v[1], v[2]);
    s.b = 10;
    *inside += 5;
    printf("%d %d\n", s.b, *inside);
    ((unsigned char *) &s.a)[1] = 1;
    printf("%d\n", s.a);
    return 0;
}
