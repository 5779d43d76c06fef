/* Complex numbers: operators, conversions, constants. */
#include <stdio.h>
#include <complex.h>
typedef double complex dc;
struct z {
    float complex f;
    double _Complex d;
};
dc g = 1 + 2*I;
static float complex gf[2] = { 1.0f, 2.0if };
dc mul(dc a, dc b) {
    return a * b;
}

static float complex fm(float complex a) {
    return a + 1;
}

static void pr(const char *n, dc v) {
    printf("%s %.6g %.6g\n", n, creal(v), cimag(v));
}

int main(void) {
    dc a = 3 + 4*I, b = 1 - 2*I;
    pr("add", a + b);
    pr("sub", a - b);
    pr("mul", mul(a, b));
    pr("div", a / b);
    pr("neg", -a);
    pr("conj", ~a);
    pr("conj", conj(a));
    printf("%g %g\n", cabs(a), carg(b));
    printf("%d %d\n", a == b, a != b);
    printf("%d\n", a && 1);
    if (!a) puts("zero");
    a += 1;
    pr("+=", a);
    a *= b;
    pr("*=", a);
    a /= 2;
    pr("/=", a);
    __real__ a = 7;
    __imag__ a = 8;
    pr("parts", a);
    printf("%g %g\n", __real__ a, __imag a);
    a++;
    pr("++", a);
    struct z s = { 1 + I, 2 - I };
    s.f += 1;
    pr("s", s.f);
    pr("s", s.d);
    double d = a;
    printf("%g\n", d);
    int i = (int) a;
    printf("%d\n", i);
    printf("%d %d\n", (int)sizeof(dc), (int)sizeof(float complex));
    dc arr[2] = { 1, I };
    pr("arr", arr[1] * arr[1]);
    dc *p = &arr[0];
    pr("p", p[1]);
    pr("t", a == 0 ? a : b);
    pr("fm", fm(2 + I));
    pr("csqrt", csqrt(-4));
    pr("cexp", cexp(I * 3.14159265358979));
    pr("cpow", cpow(2 + I, 2));
    pr("g", g);
    pr("gf", gf[1]);
    pr("clog", clog(b));
    pr("csin", csin(b));
    printf("%g\n", crealf(fm(1)));
    float complex fc = 1.5f + 2.5fi;
    printf("%g %g\n", crealf(fc), cimagf(fc));
    pr("cast", (dc) 3);
    pr("proj", cproj(a));
    _Complex double w = { 1, 2 };
    pr("w", w);
    dc cm = CMPLX(1, -0.0);
    printf("%g\n", cimag(cm));
    pr("builtin", __builtin_complex(3.0, 4.0));
    __complex__ float old = 2.0f;
    printf("%g\n", __real__ old);
    pr("int*", 2 * b);
    pr("i/", 1 / b);
    pr("comma", (a, b));
    printf("%d\n", (int) sizeof(__real__ fc));
    pr("ctan", ctan(b));
    pr("cosh", ccosh(b));
    pr("asin", casin(b));
    return 0;
}
