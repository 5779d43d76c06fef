/* The same counter is increased in both operands. */
#include <stdio.h>
int main(void)
{
    int ticks = 3, sum;
    sum = ticks++ + PLANT(ticks++, 4); // warning: unsequenced
    printf("%d %d\n", sum, ticks);
    return 0;
}
