/* An index far behind a table, in the middle of another one. */
#include <stdio.h>
static short heading[8];
static short speed[400];
static int slot(int n) { return n * 20 + 10; }
int main(void)
{
    int n = slot(PLANT(7, 0)) - PLANT(0, 9);
    speed[3] = 1;
    heading[n] = 90; // error: out of bounds
    printf("%d\n", heading[1] + speed[3]);
    return 0;
}
