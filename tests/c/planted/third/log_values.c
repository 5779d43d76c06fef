/* A log function expects a double for each name. */
#include <stdarg.h>
#include <stdio.h>
static double log_values(int count, ...)
{
    double total = 0;
    va_list list;
    va_start(list, count);
    while (count-- > 0) {
        const char *name = va_arg(list, const char *);
        total += name[0] + va_arg(list, double); // error: mismatched argument
    }
    va_end(list);
    return total;
}
int main(void)
{
    double d = log_values(2, "x", 1.5, "y", PLANT(2, 2.0));
    printf("%d\n", d > 0);
    return 0;
}
