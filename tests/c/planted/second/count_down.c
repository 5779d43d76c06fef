/* A difference of large numbers does not fit. */
#include <stdio.h>
static int distance(int a, int b)
{
    return a - b; // error: signed overflow
}
int main(void)
{
    printf("%d\n", distance(-2000000000, PLANT(2000000000, 20)) < 0);
    return 0;
}
