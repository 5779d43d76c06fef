/* Long and deeply nested expressions, with more live values than any machine has registers. */
#include <stdio.h>

static int f(int n) { return n * n - 3; }

int main(void)
{
    int a = 1, b = 2, c = 3, d = 4, e = 5, g = 6, h = 7, i = 8, j = 9, k = 10;
    double x = 0.5, y = 1.5;

    printf("%d\n", a + (b + (c + (d + (e + (g + (h + (i + (j + (k * 2))))))))));
    printf("%d\n", ((((((((a * 2 + b) * 2 + c) * 2 + d) * 2 + e) * 2 + g) * 2 + h) * 2 + i) * 2 + j));
    printf("%d\n", (a * b + c * d) * (e * g + h * i) - (a + j) * (b + i) * (c + h) % (d + k));
    printf("%d\n", f(a + f(b + f(c) - f(d)) % 100) + f(f(e) % f(g)) - f(h - i * j));
    printf("%d\n", f(1) + f(2) + f(3) + f(4) + f(5) + f(6) + f(7) + f(8) + f(9) + f(10));
    printf("%d\n", a < b && b < c && (c < d || d > e) && !(e > g) && (g < h ? h < i : i < j));
    printf("%g\n", (x + a) * (y - b) / ((x * c) + (y / d)) - (e + x) * (g - y));
    printf("%d\n", (a | b << 1 | c << 2 | d << 3) ^ (e & g) + (h - i) * (j ^ k));
    printf("%d\n", ((a ? b : c) + (d ? e : g)) * ((h > i ? j : k) - (a == 1 ? 2 : 3)));
    return 0;
}
