/* A pointer to an array that is known, moved behind its end. */
#include <stdio.h>
static int a[10], b[100];
int main(void)
{
    int *p = a + 2, n = PLANT(20, 5);
    b[12] = 7;
    p[n] = 3; // error: out of bounds
    printf("%d %d\n", a[7], b[12]);
    return 0;
}
