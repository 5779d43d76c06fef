/* A pointer that is set once, to an array. */
#include <stdio.h>
static int scan[6] = {3, 1, 4, 1, 5, 9}, spare[200];
int main(void)
{
    int *from = scan, i, sum = 0;
    spare[30] = 1;
    for (i = 0; i < PLANT(40, 2); i += 39)
        sum += from[i]; // error: out of bounds
    printf("%d\n", sum + spare[0]);
    return 0;
}
