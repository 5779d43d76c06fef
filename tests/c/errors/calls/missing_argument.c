/* A variadic function reads more than it was passed. */
#include <stdarg.h>

static int sum(int count, ...)
{
    va_list ap;
    int total = 0;

    va_start(ap, count);
    while (count-- > 0)
        total += va_arg(ap, int); // error: missing argument
    va_end(ap);
    return total;
}

int main(void)
{
    return sum(3, 1, 2);
}
