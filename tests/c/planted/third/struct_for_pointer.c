/* A struct is passed where its address is expected. */
#include <stdarg.h>
#include <stdio.h>
struct pose { int x, y; };
static int far(int n, ...)
{
    va_list list;
    const struct pose *p;
    va_start(list, n);
    p = va_arg(list, const struct pose *); // error: mismatched argument
    va_end(list);
    return p->x > n;
}
int main(void)
{
    struct pose here = {70000, 4};
    printf("%d\n", far(3, PLANT(here, &here)));
    return 0;
}
