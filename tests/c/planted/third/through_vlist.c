/* The list is handed to another function, which reads a long long. */
#include <stdarg.h>
#include <stdio.h>
static long long next(va_list *list) { return va_arg(*list, PLANT(long long, int)); } // error: mismatched argument
static long long sum(int n, ...)
{
    va_list list;
    long long s = 0;
    va_start(list, n);
    while (n--)
        s += next(&list);
    va_end(list);
    return s;
}
int main(void) { printf("%d\n", sum(3, 1, 2, 3) != 0); return 0; }
