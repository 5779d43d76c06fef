/* Example: an int is passed where a double is read. */
#include <stdarg.h>
#include <stdio.h>

static double mean(int count, ...)
{
    double sum = 0.0;
    va_list list;
    int i;

    va_start(list, count);
    for (i = 0; i < count; i++)
        sum += va_arg(list, double); // error: mismatched argument
    va_end(list);
    return sum / count;
}

int main(void)
{
    printf("%.2f\n", mean(2, 1.5, 2.5));
    printf("%.2f\n", mean(3, 1.5, 2, 2.5));
    return 0;
}
