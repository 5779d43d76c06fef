/* Structs as arguments and results are copies. */
#include <stdio.h>

struct vector { double x, y; };
struct tiny { char c; };
struct large { int v[20]; char tag; };
struct mixed { char c; short s; float f; long long ll; };

static struct vector add(struct vector a, struct vector b)
{
    a.x += b.x;
    a.y += b.y;
    return a;
}

static struct vector scaled(double k, struct vector v, int flip)
{
    struct vector r = { k * v.x, k * v.y };

    return flip ? (struct vector) { -r.x, -r.y } : r;
}

static struct tiny next(struct tiny t)
{
    t.c++;
    return t;
}

static int sum(struct large l)
{
    int i, s = 0;

    for (i = 0; i < 20; i++)
        s += l.v[i];
    l.v[0] = -1;
    l.tag = 'z';
    return s;
}

static struct large counted(int start)
{
    struct large l;
    int i;

    for (i = 0; i < 20; i++)
        l.v[i] = start++;
    l.tag = 'a' + start % 26;
    return l;
}

static struct mixed mix(char a, struct mixed m, short b)
{
    m.c += a;
    m.s *= b;
    m.f /= 2;
    m.ll = -m.ll;
    return m;
}

int main(void)
{
    struct vector a = { 1, 2 }, b = { 10, 20 }, c;
    struct tiny t = { 'q' };
    struct large l = counted(5);
    struct mixed m = { 1, -2, 3.5f, 4000000000ll };

    c = add(a, add(b, b));
    printf("%g %g %g\n", c.x, c.y, a.x);
    c = scaled(2, scaled(0.5, c, 1), 0);
    printf("%g %g\n", c.x, c.y);
    printf("%g %c\n", add(a, b).y, next(next(t)).c);
    printf("%d %d %c %d\n", sum(l), l.v[0], l.tag, sum(counted(100)));
    printf("%d %c\n", counted(7).v[3], counted(1).tag);
    m = mix(5, m, 7);
    printf("%d %d %g %lld\n", m.c, m.s, m.f, m.ll);
    a = b = c;
    printf("%g %g\n", a.x, b.y);
    return 0;
}
