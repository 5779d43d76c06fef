/* A double is read where an int was passed last. */
#include <stdarg.h>

static double take(int n, ...)
{
    va_list ap;
    double d;

    va_start(ap, n);
    d = va_arg(ap, double); // error: mismatched argument
    va_end(ap);
    return d;
}

int main(void)
{
    return take(1, 2) > 0;
}
