/* Complex integers of GNU C: parts of every size, no promotions, quotients as gcc computes them. */
#include <stdarg.h>
#include <stdio.h>

#define SHOW(z) printf("%lld %lld\n", (long long)__real__(z), (long long)__imag__(z))
#define SIZE(z) ((int) sizeof(z))

struct record { char tag; short _Complex z; };

static int _Complex start = 3 + 4i, sum = (1 + 2i) * (5 - 3i), quarter = 2i / 2;
static unsigned char _Complex table[3] = { 1, 200i, 250 + 7i };

static unsigned _Complex add(unsigned _Complex a, int _Complex b)
{
    return a + b;
}

static void variadic(int count, ...)
{
    va_list rest;
    va_start(rest, count);
    while (count-- > 0) {
        int _Complex z = va_arg(rest, int _Complex);
        SHOW(z);
    }
    va_end(rest);
}

static void operators(void)
{
    int _Complex a = 1 + 2i, b, product;
    __real__ b = 5;
    __imag__ b = -3;
    SHOW(a + b); SHOW(a - b); SHOW(a * b); SHOW(-a); SHOW(+a); SHOW(~a);
    product = a * b; SHOW(product / b); SHOW(b / a); SHOW(100 / a); SHOW(b / 2); SHOW(7 - a); SHOW(a + 'A');
    SHOW(a / 2i); SHOW((a * 1000 + 7i) / (3 - 40i));
    a += 3; a -= 1i; a *= b; a /= 2 + 1i;
    SHOW(a); SHOW(a++); SHOW(--a);
    printf("%d %d %d %d\n", a == b, a != b, a == a, !a);
    if (a && !(a - a)) puts("true");
    printf("%d %d\n", (_Bool)(0 + 1i), (_Bool)(int _Complex)0);
    SHOW(b ? a : b); SHOW((SHOW(a), b));
}

static void conversions(void)
{
    int _Complex a = -2 + 300i;
    signed char _Complex c = a;
    long long _Complex l = a;
    double _Complex d = a;
    unsigned short _Complex u = a;
    c = c + c;
    l *= 1000000000;
    d = d * a / 2;
    SHOW(c); SHOW(l); SHOW(u); SHOW(u / (c + 1)); SHOW(-u);
    SHOW((unsigned _Complex) (5 + 9i) / (2 + 3i)); SHOW((9ull + 2i) / (1 + 4i));
    printf("%g %g\n", __real__ d, __imag__ d);
    a = d;
    SHOW(a); SHOW(a + 1.5); SHOW((int) a);
    printf("%d %d %d %d %d\n", SIZE(c + c), SIZE(c + 1), SIZE(1i), SIZE(l), SIZE(1.0fi));
    printf("%d %d\n", SIZE(struct record), (int) _Alignof(long long _Complex));
}

int main(void)
{
    struct record r = { 1, { 2 } };
    int i;
    r.z = start;
    r.z++;
    SHOW(r.z); SHOW(sum); SHOW(quarter);
    for (i = 0; i < 3; i++) { table[i] *= 3; SHOW(table[i]); }
    SHOW(add(7, start));
    variadic(2, start, sum);
    operators();
    conversions();
    return 0;
}
