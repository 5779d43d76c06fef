/* A function like printf that reads its arguments by their letters. */
#include <stdarg.h>
#include <stdio.h>

static double total(const char *kinds, ...)
{
    va_list list;
    double sum = 0;

    va_start(list, kinds);
    for (; *kinds; kinds++)
        if (*kinds == 'd')
            sum += va_arg(list, double); // error: mismatched argument
        else
            sum += va_arg(list, int);
    va_end(list);
    return sum;
}

int main(void)
{
    printf("%g\n", total("did", 1.5, 2, PLANT(3, 3.0)));
    return 0;
}
