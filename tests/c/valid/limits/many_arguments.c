/* Sixty parameters of mixed types. */
#include <stdio.h>

#define P(t, x) t x##0, t x##1, t x##2, t x##3, t x##4, t x##5, t x##6, t x##7, t x##8, t x##9
#define SUM(x) (x##0 + 2 * x##1 + 3 * x##2 + 4 * x##3 + 5 * x##4 + 6 * x##5 + 7 * x##6 + 8 * x##7 + 9 * x##8 + 10 * x##9)

static double many(P(int, a), P(char, b), P(double, c), P(long long, d), P(float, e), P(short, f))
{
    return SUM(a) + SUM(b) * 2.0 + SUM(c) * 3 + SUM(d) * 4.0 + SUM(e) * 5 + SUM(f) * 6.0;
}

int main(void)
{
    printf("%.4f\n", many(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10,
                          .1, .2, .3, .4, .5, .6, .7, .8, .9, 1, 1ll << 33, 2, 3, 4, 5, 6, 7, 8, 9, 10,
                          1.5f, 2.5f, 3.5f, 4.5f, 5, 6, 7, 8, 9, 10, 100, 200, 300, 400, 500, 600, 700,
                          800, 900, 1000));
    return 0;
}
