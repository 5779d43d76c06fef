/* Names that are nearly keywords, and are not. */
#include <stdio.h>

typedef int void_t;
typedef double flaot;

static int whlie(int n)
{
    return n + 1;
}

int main(void)
{
    int esle = 1, retrun = 2;
    void_t viod = 3;
    flaot fro = 1.5;

    if (esle) whlie(2);
    esle - 1;
    retrun * viod;
    whlie (viod)
    ;
    goto braek;
braek:
    printf("%d %d %d %.1f\n", esle, whlie(retrun), viod, fro);
    return 0;
}
