/* A format chosen at run time does not fit its argument. */
#include <stdio.h>
static const char *unit(int metric) { return metric ? "%d mm\n" : "%f in\n"; }
int main(void)
{
    const char *format = unit(PLANT(0, 1));
    printf(format, 254); // error: mismatched argument
    return 0;
}
