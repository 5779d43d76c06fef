/* A negative index that wraps around to the top of the address space. */
#include <stdio.h>

static double table[4], *at = table;

int main(void)
{
    int i = -200 * 1000 * 1000;

    printf("%g\n", at[i]); // error: pointer outside memory
    return 0;
}
