/* Structs passed through ... and read with va_arg. */
#include <stdio.h>
#include <stdarg.h>

struct point { int x, y; };
struct odd { char c[5]; };
struct wide { double d; short s; };

static int path(int n, ...)
{
    va_list ap;
    struct point p, last = { 0, 0 };
    int length = 0;

    va_start(ap, n);
    while (n--) {
        p = va_arg(ap, struct point);
        length += (p.x > last.x ? p.x - last.x : last.x - p.x)
                + (p.y > last.y ? p.y - last.y : last.y - p.y);
        last = p;
    }
    va_end(ap);
    return length;
}

static void mixed(int n, ...)
{
    va_list ap;
    struct odd o;
    struct wide w;
    int i;

    va_start(ap, n);
    o = va_arg(ap, struct odd);
    i = va_arg(ap, int);
    w = va_arg(ap, struct wide);
    printf("%.5s %d %g %d %c\n", o.c, i, w.d, w.s, va_arg(ap, struct odd).c[4]);
    va_end(ap);
}

int main(void)
{
    struct point a = { 3, 4 }, b = { -1, 2 };
    struct odd o = { "fives" };
    struct wide w = { 2.5, -9 };

    printf("%d\n", path(3, a, b, (struct point) { 0, 0 }));
    mixed(4, o, 42, w, o);
    return 0;
}
