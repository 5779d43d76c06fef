/* Pointer arithmetic counts in objects (C17 6.5.6p8). */
#include <stdio.h>
#include <stddef.h>

struct wide { int a; char b[9]; };

int main(void)
{
    int v[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    struct wide w[5] = { { 0 } };
    double d[4] = { 0.5, 1.5, 2.5, 3.5 };
    char text[] = "pointer";
    int *p = v, *end = v + 8, *q;
    struct wide *s = w + 4;
    double *dp = &d[3];
    char *c;
    ptrdiff_t gap;

    printf("%d %d %d\n", *(p + 3), *(3 + p), *(end - 1));
    gap = end - p;
    printf("%d %d\n", (int) gap, (int) (p - end));
    printf("%d %d\n", (int) (s - w), (int) ((char *) s - (char *) w));
    printf("%d %d\n", (int) (dp - d), (int) (&d[1] - &d[3]));
    for (q = end; q-- > p;)
        printf("%d ", *q);
    printf("\n");
    for (q = v; q < end; q += 3)
        printf("%d ", *q);
    printf("\n");
    for (c = text; *c; c++)
        ;
    printf("%d\n", (int) (c - text));
    p += 2;
    p[1] = 30;
    p[-1] = 10;
    printf("%d %d %d\n", v[3], v[1], *p);
    printf("%d\n", 2[v] + v[2] + *(v + 2));
    dp -= 2;
    printf("%g %g\n", *dp, dp[1]);
    printf("%d %d %d\n", p > v, p == &v[2], &v[3] >= p + 2);
    p = &v[1] + (v[1] == 10);
    printf("%d\n", (int) (p - v));
    q = &*p;
    printf("%d\n", q == p);
    return 0;
}
