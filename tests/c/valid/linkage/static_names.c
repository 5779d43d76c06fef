/* Statics of the same name in different functions and blocks are different objects. */
#include <stdio.h>

static int state = 1;

static int a(void) { static int state = 10; return state++; }
static int b(void) { static int state = 20; return state++; }

static int c(int deep)
{
    static int n = 0;
    if (deep) {
        static int n = 100;
        return n++;
    }
    return n++;
}

int main(void)
{
    int i;

    for (i = 0; i < 2; i++)
        printf("%d %d %d %d %d\n", state++, a(), b(), c(0), c(1));
    {
        static int state = 50;
        int *p = &state;
        ++*p;
        printf("%d\n", state);
    }
    printf("%d\n", state);
    return 0;
}
