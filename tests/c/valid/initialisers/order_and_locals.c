/* Automatic initialisers run each time the declaration is reached, in order. */
#include <stdio.h>

static int next(void)
{
    static int n;
    return ++n;
}

static int area(int w, int h)
{
    int dims[2] = { w, h }, a = dims[0] * dims[1], *p = &a;
    struct { int a, *p; } s = { *p + 1, p };

    *s.p += s.a;
    return a;
}

int main(void)
{
    int a = next(), b = a + next(), c[3] = { b, a, a + b };
    int i;

    printf("%d %d %d %d %d\n", a, b, c[0], c[1], c[2]);
    for (i = 0; i < 3; i++) {
        int fresh[4] = { i, i * i };
        int total = fresh[0] + fresh[1] + fresh[2] + fresh[3];
        char name[6] = "loop";
        fresh[2] = fresh[3] = 1000;
        name[4] = '0' + i;
        printf("%d %s ", total, name);
    }
    printf("\n%d %d\n", area(3, 4), area(0, 5));
    i = 0;
again:
    {
        int v[2] = { i + 1 };
        v[1] += v[0];
        printf("%d ", v[1]);
    }
    if (++i < 3)
        goto again;
    printf("\n");
    return 0;
}
