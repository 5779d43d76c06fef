/* va_start belongs into variadic functions. */
#include <stdarg.h>

static int f(int n)
{
    va_list list;
    va_start(list, n); // error: 'va_start' used in function with fixed args
    va_end(list);
    return n;
}

int main(void)
{
    return f(1);
}
