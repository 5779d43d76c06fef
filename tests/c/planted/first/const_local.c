/* A constant in a function is changed. */
#include <stdio.h>
int main(void)
{
    const int radius = 15;
    int copy = radius;
    int *p = PLANT((int *)&radius, &copy);
    *p = 16; // error: write to read-only memory
    printf("%d\n", *p);
    return 0;
}
