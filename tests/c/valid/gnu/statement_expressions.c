/* Nested statement expressions: loops and switches inside, values around them that must survive. */
#include <stdio.h>

static int g(int a, int b, int c) { return a * 100 + b * 10 + c; }
static double h(double a, double b) { return a * 3 + b; }
static int n;
static int next(void) { return ++n; }
struct p { int x, y; };
static struct p mk(int a) { struct p q = {a, a + 1}; return q; }
int main(void)
{
    int i, v[10] = {0}, t;
    for (i = 0; i < 4; i++)
        v[next() + ({
            int k = i;
            for (int j = 0; j < 3; j++)
                k += v[j] + next();
            k & 1;
        }) & 7] += next() * ({ int z = next(); if (z & 1) z++; z; }) + v[i];
    for (i = 0; i < 10; i++)
        printf("%d ", v[i]);
    printf("%d\n", g(next() + 1, ({ int a = next(); while (a > 5) a -= 3; a; }),
                     next() ? ({ int q = next(); q > 3 ? q : -q; }) : 0));
    printf("%g\n", h(next() * 1.5 + ({ double d = 0; for (t = 0; t < 3; t++) d += t * 0.5; d; }), ({
        switch (next() & 3) {
        case 0: t = 5; break;
        case 1: t = 7; break;
        default: t = 9;
        }
        (float)t;
    })));
    struct p a = ({ struct p b = mk(next()); b.x += b.y; b; });
    printf("%d %d %d\n", a.x, a.y,
           mk(3).y + ({ mk(next()); }).x * ({ int r = 0; do r += mk(r).y; while (r < 9); r; }));
    int arr[] = {
        next(), ({ int w = next(); w * w; }), mk(next()).y, ({ int u; { u = next(); } u; }),
    };
    printf("%d %d %d %d\n", arr[0], arr[1], arr[2], arr[3]);
    t = (i = 3, ({ i++; }) + ({ i += 2; i; }) * 2);
    printf("%d %d\n", t, i);
    if (({ int any = 0; for (i = 0; i < 4 && !any; i++) any = arr[i] > 20; any; })
        && ({ t = i; t; }) > 1)
        printf("any %d\n", t);
    while (({ t--; t; }) > 0 || ({ 0; }))
        if (t == 2)
            break;
    printf("%d %d\n", t, t > 1 ? ({ int x = 5; x + t; }) : ({ 7; }));
    return 0;
}
