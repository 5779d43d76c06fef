/* A long long is taken out in two halves. */
#include <stdarg.h>
#include <stdio.h>
static int largest(int count, ...)
{
    va_list list;
    int most = 0;
    va_start(list, count);
    while (count-- > 0) {
        int n = va_arg(list, int); // error: mismatched argument
        if (n > most)
            most = n;
    }
    va_end(list);
    return most;
}
int main(void)
{
    printf("%d\n", largest(3, 1, 2, PLANT(5LL, 5)));
    return 0;
}
