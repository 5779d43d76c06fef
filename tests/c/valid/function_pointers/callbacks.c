/* Functions as arguments: map, fold, filter, iteration with context. */
#include <stdio.h>

typedef int (*unary)(int);
typedef int (*binary)(int, int);
typedef int predicate(int);

static int twice(int n) { return 2 * n; }
static int negate(int n) { return -n; }
static int is_even(int n) { return n % 2 == 0; }
static int plus(int a, int b) { return a + b; }
static int larger(int a, int b) { return a > b ? a : b; }

static void map(int *v, int n, unary f)
{
    while (n-- > 0)
        v[n] = f(v[n]);
}

static int fold(const int *v, int n, int start, int f(int, int))
{
    int i;

    for (i = 0; i < n; i++)
        start = f(start, v[i]);
    return start;
}

static int filter(int *v, int n, predicate *keep)
{
    int i, kept = 0;

    for (i = 0; i < n; i++)
        if (keep(v[i]))
            v[kept++] = v[i];
    return kept;
}

static void each(const int *v, int n, void (*visit)(int value, void *context), void *context)
{
    for (; n; n--)
        visit(*v++, context);
}

struct stats { int count; long sum; };

static void note(int value, void *context)
{
    struct stats *s = context;
    s->count++;
    s->sum += value * value;
}

static unary chosen(int which) { return which ? negate : twice; }
static int apply_twice(unary f, int n) { return f(f(n)); }

int main(void)
{
    int v[] = { 3, 8, -2, 7, 10, 1 }, n = 6;
    struct stats s = { 0, 0 };

    printf("%d %d\n", fold(v, n, 0, plus), fold(v, n, -100, larger));
    map(v, n, twice);
    map(v, n - 1, negate);
    printf("%d %d %d\n", v[0], v[4], v[5]);
    each(v, n, note, &s);
    printf("%d %ld\n", s.count, s.sum);
    v[1]++;
    n = filter(v, n, is_even);
    printf("%d %d\n", n, v[1]);
    printf("%d %d %d\n", chosen(0)(5), chosen(1)(5), apply_twice(chosen(0), 3));
    return 0;
}
