/* Inner declarations hide outer ones, each in its own space of names. */
#include <stdio.h>

int x = 1;
struct x { int x; };
enum { LOW = 1 };

static int f(int x)
{
    x += 10;
    {
        int x = 100;
        x++;
        {
            struct x { char x[7]; } v;
            int LOW = sizeof v;
            x += LOW;
        }
        if (x > 100) {
            extern int x;
            x++;
        }
    }
    return x;
}

int main(void)
{
    struct x x = { 5 };
    int i = 3;

    printf("%d %d\n", f(1), x.x);
    {
        int i = i = 4;
        printf("%d\n", i);
    }
    {
        int size = sizeof(i), i = 9;
        printf("%d %d\n", size, i);
    }
x:
    if (x.x-- > 3)
        goto x;
    printf("%d %d\n", x.x, i);
    for (int i = 0; i < 2; i++) {
        int i = 50;
        printf("%d ", i++);
    }
    printf("%d\n", i);
    {
        extern int x;
        printf("%d\n", x);
    }
    {
        int LOW = 2;
        enum { HIGH = 7 };
        printf("%d %d\n", LOW, HIGH);
    }
    {
        int printf = 3;
        i += printf;
    }
    printf("%d %d\n", i, LOW);
    return 0;
}
