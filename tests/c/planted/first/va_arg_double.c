/* An int is passed where a double is taken out. */
#include <stdarg.h>
#include <stdio.h>
static double mean(int count, ...)
{
    va_list list;
    double sum = 0;
    int i;
    va_start(list, count);
    for (i = 0; i < count; i++)
        sum += va_arg(list, double); // error: mismatched argument
    va_end(list);
    return sum / count;
}
int main(void)
{
    printf("%g\n", mean(3, 1.0, PLANT(2, 2.0), 3.0));
    return 0;
}
