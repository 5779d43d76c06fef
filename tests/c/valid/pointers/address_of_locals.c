/* Locals whose address is taken, in loops and recursion, keep apart and keep their values. */
#include <stdio.h>

static int *latest;

static int depth_sum(int n, int *outer)
{
    int mine = n;

    latest = &mine;
    if (outer)
        *outer += 100;
    if (n == 0)
        return mine;
    return depth_sum(n - 1, &mine) + mine;
}

static void fill(int *a, int *b, long long *c, float *d)
{
    *a = 1;
    *b = *a + 1;
    *c = *b * 10000000000ll;
    *d = *c / 4.0f;
}

static int counter(int start)
{
    int i, n = start, *p = &n;

    for (i = 0; i < 5; i++) {
        int step = i * 2, *q = &step;
        *p += *q;
        *q = -1;
    }
    return n;
}

int main(void)
{
    int a, b, i = 3, *pi = &i;
    long long c;
    float d;

    printf("%d\n", depth_sum(4, 0));
    fill(&a, &b, &c, &d);
    printf("%d %d %lld %g\n", a, b, c, d);
    printf("%d\n", counter(7));
    while ((*pi)--)
        printf("%d ", i);
    printf("\n");
    for (i = 0; i < 3; ++*pi)
        printf("%d ", *&i);
    printf("\n");
    return 0;
}
