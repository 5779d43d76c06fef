/* Complex numbers: exact products and quotients, and every place where they can be used. */
// without gcc: for -m32 its library divides in the extended precision of the x87
#include <stdio.h>
#include <stdarg.h>
#include <complex.h>
#include <math.h>
#include <stdlib.h>
typedef double complex dc;
typedef float complex fc;
static void show(dc v) {
    printf("%a %a\n", creal(v), cimag(v));
}

static void showf(fc v) {
    printf("%a %a\n", (double) crealf(v), (double) cimagf(v));
}

/* The last bits of a quotient are those of the host's wider registers. */
static void show_quotient(dc v) {
    printf("%.13g %.13g\n", creal(v), cimag(v));
}

static dc sum(int n, ...) {
    va_list l;
    va_start(l, n);
    dc s = 0;
    while (n-- > 0) s += va_arg(l, dc);
    va_end(l);
    return s;
}

struct wave {
    int n;
    dc v[2];
    fc f;
};
static struct wave w0 = { 1, { 2 - 1.0i, 3 }, 0.5f + 0.25fi };
static dc table[] = { 1, 1.0i, -1, [5] = 2.0 * (1 + 1.0i) };
static const dc unit = 1.0i;
static dc quotient = (1 + 2.0i) / (3 - 4.0i);
static struct wave next(struct wave w) {
    w.n++;
    w.v[0] *= w.v[1];
    w.f = -w.f;
    return w;
}

static dc k_and_r(z, f) dc z;
float complex f;
{
    return z + f;
}

static dc twice(dc z) {
    return 2 * z;
}

static unsigned seed = 1;
static double rnd(void) {
    seed = seed * 1103515245u + 12345u;
    return (int)(seed >> 8) / 65536.0 - 100;
}

static int count;
static dc *at(dc *p) {
    count++;
    return p;
}

int main(void) {
    for (int i = 0; i < 12; i++) {
        dc a = CMPLX(rnd(), rnd()), b = CMPLX(rnd(), rnd());
        show(a * b);
        show_quotient(a / b);
        show(a + b);
        show_quotient(3 / b);
        show(b / 3.0f);
        show(7 - a);
        fc x = a, y = b;
        showf(x * y);
        showf(x / y);
        showf(x - y);
        show(x * b);
    }
    double s[] = { 0.0, -0.0, 1, INFINITY, -INFINITY, 1e308, 1e-308 };
    for (int i = 0; i < 7; i++) for (int j = 0; j < 7; j++) {
        dc p = CMPLX(s[i], s[j]) * CMPLX(s[j], s[6 - i]), q = CMPLX(s[i], 1) / CMPLX(s[j], s[i]);
        printf("%g %g %g %g\n", fabs(creal(p)), fabs(cimag(p)), fabs(creal(q)), fabs(cimag(q)));
    }
    show(sum(3, (dc) 1, 2.0i, CMPLX(3, 4)));
    struct wave w = next(w0);
    printf("%d\n", w.n);
    show(w.v[0]);
    showf(w.f);
    show(table[1] * table[5]);
    show(table[3]);
    show(unit);
    show(quotient);
    show(k_and_r(1 + 2.0i, (fc) 3.0fi));
    dc (*f)(dc) = twice;
    show(f(unit));
    dc z = 5;
    show(z++);
    show(z);
    show(--z);
    show(*at(&z) *= 2 - 1.0i);
    (*at(&z))++;
    printf("%d\n", count);
    show(z);
    int n = 3;
    n += 2.75 + 1.0i;
    printf("%d\n", n);
    double d = 2;
    d *= 1 + 1.0i;
    printf("%g\n", d);
    _Bool t = 0.0i, u = 0.5i;
    printf("%d %d\n", t, u);
    show(t ? z : 1);
    show(u ? 2.5f : z);
    printf("%d %d %d %d\n", z == z, z != 0, z && u, z || 0);
    if (z) puts("yes");
    while (z != 0) {
        z = 0;
    }
    for (; z; ) ;
    if (!z) puts("zero");
    __real__ z = 3;
    __imag__ w.f = 9;
    show(z);
    showf(w.f);
    double *re = &__real__ z;
    *re = 8;
    show(z);
    printf("%d %d\n", (int) sizeof(fc), (int) sizeof(dc));
    printf("%s\n", _Generic(z, double: "double", dc: "dc", fc: "fc"));
    printf("%s\n", _Generic(1.0fi * 2, double: "double", dc: "dc", fc: "fc"));
    dc *h = malloc(2 * sizeof *h);
    h[1] = z;
    h[0] = h[1] - 1;
    show(h[0]);
    free(h);
    show((dc) { 4 });
    show(~(z + 1.0i));
    printf("%g %g\n", __real__ 3.5, __imag__ 3.5);
    dc c = { 6 };
    show(c);
    volatile dc v = 1;
    v += 1.0i;
    show(v);
    show((c, z));
    return 0;
}
