/* The conditional operator: types, nesting, side effects and struct operands. */
#include <stdio.h>

struct point { int x, y; };

static int count;
static int tick(int n) { count++; return n; }

static const char *sign(int n)
{
    return n < 0 ? "negative" : n > 0 ? "positive" : "zero";
}

int main(void)
{
    int i = 3, a = 1, b = 2;
    unsigned u = 1;
    struct point p = { 1, 2 }, q = { 3, 4 }, r;
    const char *text;
    void *any = &i;
    int *ip;

    printf("%s %s %s\n", sign(-5), sign(0), sign(5));
    printf("%d\n", i > 2 ? tick(10) : tick(20));
    printf("%d\n", count);
    printf("%g %g\n", 1 ? 1 : 2.5, 0 ? 1 : 2.5);
    printf("%d\n", (1 ? -1 : u) > 0);
    r = i == 3 ? p : q;
    printf("%d %d\n", r.x, r.y);
    printf("%d\n", (i == 4 ? p : q).y);
    *(i > 0 ? &a : &b) = 99;
    printf("%d %d\n", a, b);
    text = i ? "yes" : 0;
    printf("%s\n", text);
    ip = i > 5 ? 0 : any;
    printf("%d\n", *ip);
    i > 2 ? (a = 7) : (b = 7);
    printf("%d %d\n", a, b);
    printf("%d\n", a > b ? a > 5 ? 1 : 2 : 3);
    i > 100 ? (void) tick(0) : (void) (b = 11);
    printf("%d %d\n", b, count);
    printf("%d\n", 5 + (i ? 1 : 0) * 3);
    printf("%c\n", "01"[i ? 1 : 0]);
    return 0;
}
