/* K&R definitions: arguments for parameters of every type are promoted (C17 6.9.1p10). */
#include <stdio.h>

struct pair { int a, b; };

static int small(c, s, u)
    char c;
    short s;
    unsigned char u;
{
    return c * 10000 + s * 10 + u;
}

static double floats(f, d, i)
    float f;
    double d;
    int i;
{
    return f + d * i;
}

static char *pointers(text, v, f)
    char *text;
    int v[];
    int (*f)();
{
    text[v[0]] = (*f)(v[1]);
    return text + v[0];
}

static struct pair swap(p, by)
    struct pair p;
    long long by;
{
    struct pair r;

    r.a = p.b + (int) (by >> 32);
    r.b = p.a;
    return r;
}

static upper(c) { return c - 32; }
static int no_parameters() { return 1; }

int main(argc, argv)
    int argc;
    char *argv[];
{
    char text[] = "lower";
    int v[2] = { 2, 'w' };
    struct pair p = { 1, 2 };
    float f = 0.5f;

    printf("%d\n", small(-3, -2, 200));
    printf("%d\n", small(300, 70000, 513));
    printf("%g\n", floats(f, 1.5, 4));
    printf("%s", pointers(text, v, upper));
    printf(" %s\n", text);
    p = swap(p, 10ll << 32);
    printf("%d %d %d\n", p.a, p.b, no_parameters() + argc - 1);
    return 0;
}
