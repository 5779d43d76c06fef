/* A function without a return value in one branch. */
#include <stdio.h>

static int sign(int value)
{
    if (value > 0)
        return 1;
    if (value < 0)
        return -1;
    PLANT(, return 0;)
}

int main(void)
{
    int (*test)(int) = sign;

    printf("%d\n", test(3) + test(0)); // error: no value returned
    return 0;
}
