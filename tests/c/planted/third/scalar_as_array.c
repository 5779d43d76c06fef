/* The address of one number is used as if many followed. */
#include <stdio.h>
static int limit = 5, table[300];
int main(void)
{
    int *p = &limit, i = PLANT(40, 0);
    table[2] = 1;
    printf("%d\n", p[i] + table[3]); // error: out of bounds
    return 0;
}
