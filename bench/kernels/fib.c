/* Recursive Fibonacci: nothing but calls. */
#include <stdio.h>

static int fib(int n)
{
    return n < 2 ? n : fib(n - 1) + fib(n - 2);
}

int main(void)
{
    printf("fib %d\n", fib(36));
    return 0;
}
