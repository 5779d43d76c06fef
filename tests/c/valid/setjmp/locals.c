/* Locals keep the values that they had when the jump happened, as gcc -O0 has it. */
#include <setjmp.h>
#include <stdio.h>

struct pair { int a; double b; };

static jmp_buf env;

static void back(int value)
{
    longjmp(env, value);
}

static double mixed(int n, float f, long long big)
{
    int i = 1;
    unsigned char small = 250;
    double d = 0.5;
    struct pair p = {1, 2.0};
    register int quick = 3;
    int array[4] = {1, 2, 3, 4};

    switch (setjmp(env)) {
    case 0:
        i = 10, d *= 3, small += 10, f += 1, big <<= 33, p.a = 7, quick--, array[2] = 99;
        back(1);
    case 1:
        printf("%d %u %g %g %lld {%d %g} %d %d\n", i, small, d, f, big, p.a, p.b, quick, array[2]);
        i++, d = -d, p.b = 8, quick *= 5;
        back(i);
    case 11:
        printf("%d %g %g %d\n", i, d, p.b, quick);
        n += 100;
        back(-1);
    }
    return n + f + big + i;
}

static int counting(void)
{
    int count = 0, total = 0;

    setjmp(env);
    for (count++; count < 10; count++) {
        total += count;
        if (count % 3 == 0)
            back(1);
    }
    return total * 100 + count;
}

int main(void)
{
    printf("%g\n", mixed(5, 2.5f, 3));
    printf("%d\n", counting());
    return 0;
}
