/* INT_MIN / -1 does not fit in an int. */
#include <limits.h>
#include <stdio.h>

int main(void)
{
    volatile int n = INT_MIN, m = -1;

    printf("before\n");
    return n / m; // error: division overflow
}
