/* Example: infinite recursion. */
#include <stdio.h>

static int deeper(int n) // error: stack overflow
{
    return deeper(n + 1) + n;
}

int main(void)
{
    printf("before\n");
    return deeper(0);
}
