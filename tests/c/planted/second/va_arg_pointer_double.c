/* A double is taken for a string. */
#include <stdarg.h>
#include <stdio.h>
static int total(const char *kinds, ...)
{
    va_list list;
    int n = 0;
    va_start(list, kinds);
    for (; *kinds; kinds++)
        if (*kinds == 'd')
            n += (int)va_arg(list, double);
        else
            n += va_arg(list, int); // error: mismatched argument
    va_end(list);
    return n;
}
int main(void) { printf("%d\n", total(PLANT("di", "dd"), 1.5, 2.5)); return 0; }
