/* Functions that give every type, called through values, pointers and in expressions. */
#include <stdbool.h>
#include <stdio.h>

static char c(int n) { return n; }
static unsigned char uc(int n) { return n; }
static short s(int n) { return n; }
static unsigned short us(int n) { return n; }
static bool b(double d) { return d; }
static long long q(int n) { return (long long) n << 33; }
static unsigned long long uq(int n) { return n; }
static float f(double d) { return d / 3; }
static double d(float x) { return x / 3; }
static const char *t(int n) { return "text" + n; }
static void v(int *n) { if (*n > 5) return; ++*n; v(n); }
static int none() { return 8; }
static enum { RED, BLUE } e(int n) { return n ? BLUE : RED; }
static struct r { char x[3]; } r(void) { return (struct r) { "ab" }; }

int main(void)
{
    int n = 0;
    float (*pf)(double) = f;

    printf("%d %d %d %d\n", c(300), uc(300), s(100000), us(100000));
    printf("%d %d %d\n", c(255) == 255, uc(255) == 255, s(65535) + us(65535));
    printf("%d %d %lld %llu\n", b(0.1), b(0), q(-1), uq(-1));
    printf("%a %a %a\n", f(1), d(1), pf(2));
    v(&n);
    printf("%s %d %d %d %s\n", t(2), n, none(), e(4), r().x);
    printf("%g\n", f(3) + c(65) + q(0) + uc(-1));
    (void) none();
    none();
    return 0;
}
