/* A long long is taken out where an int was passed. */
#include <stdarg.h>
#include <stdio.h>
static long long sum(int n, ...)
{
    va_list list;
    long long s = 0;
    va_start(list, n);
    while (n--)
        s += va_arg(list, long long); // error: mismatched argument
    va_end(list);
    return s;
}
int main(void) { printf("%d\n", (int)sum(2, 1LL, PLANT(2, 2LL), 3)); return 0; }
