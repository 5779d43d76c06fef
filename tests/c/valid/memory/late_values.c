/* Variables that get their values late, in ways that a reader can follow and a compiler cannot. */
#include <stdio.h>

static int find(const int *a, int n, int wanted)
{
    int i, place, found = 0;

    for (i = 0; i < n; i++)
        if (a[i] == wanted) {
            place = i;
            found = 1;
        }
    return found ? place : -1;
}

static int running(int n)
{
    int old, now, i, sum = 0;

    for (i = 0; i < n; i++) {
        old = now;                  /* nothing yet, the first time */
        now = i * i;
        if (i > 0)
            sum += now - old;
    }
    return sum;
}

static double choose(int which)
{
    double a, b;

    if (which == 1)
        a = 1.5;
    else
        b = 2.5;
    return which == 1 ? a : b;
}

static int jump(int n)
{
    int result;

    if (n > 3)
        goto big;
    result = 1;
    goto end;
big:
    result = 2;
end:
    return result;
}

static int once(int n)
{
    int value, i;

    for (i = 0; i < n; i++) {
        if (i == 0)
            value = 10;
        value += i;
    }
    return n > 0 ? value : 0;
}

static int keep(int argc)
{
    int kept[2], first;

    if (argc > 100)
        first = 7;
    kept[0] = first;                /* stored, but never looked at */
    kept[1] = 3;
    return kept[1];
}

int main(int argc, char **argv)
{
    int a[] = { 3, 1, 4, 1, 5 };

    printf("%d %d\n", find(a, 5, 4), find(a, 5, 9));
    printf("%d %g %g %d %d\n", running(5), choose(1), choose(2), jump(2), jump(5));
    printf("%d %d %d\n", once(4), once(0), keep(argc));
    return 0;
}
