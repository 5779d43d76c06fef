/* Encoder ticks times a factor do not fit an int. */
#include <stdio.h>
static int scaled(int ticks, int factor)
{
    return ticks * factor; // error: signed overflow
}
int main(void)
{
    int ticks = 1000, i;
    for (i = 0; i < PLANT(6, 2); i++)
        ticks = scaled(ticks, 20);
    printf("%d\n", ticks > 0);
    return 0;
}
