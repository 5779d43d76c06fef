/* Prefix and postfix ++ and -- on every kind of object. */
#include <stdio.h>

struct pair {
    int a;
    unsigned char b;
};

static int calls;

static int *next(int *p)
{
    calls++;
    return p;
}

int main(void)
{
    int i = 5, array[4] = { 10, 20, 30, 40 }, *p = array;
    unsigned char c = 255;
    long long ll = 4294967295ll;
    double d = 1.5;
    float f = -0.5f;
    struct pair s = { 1, 0 }, *q = &s;

    printf("%d ", i++);
    printf("%d ", ++i);
    printf("%d ", i--);
    printf("%d\n", --i);
    printf("%d ", c++);
    printf("%d\n", c);
    printf("%d ", *p++);
    printf("%d\n", *p);
    printf("%d ", ++*p);
    printf("%d\n", (*p)++);
    printf("%d\n", *p);
    printf("%d\n", *++p);
    printf("%d\n", *--p);
    printf("%lld\n", ++ll);
    printf("%g %g\n", d++, f--);
    printf("%g %g\n", d, f);
    q->a++;
    --q->b;
    printf("%d %d\n", s.a, s.b);
    (*next(&array[3]))++;
    ++*next(array);
    printf("%d %d %d\n", array[0], array[3], calls);
    i = 0;
    array[i++] = 100;
    printf("%d\n", i);
    return 0;
}
