/* An array without a name. */
#include <stdio.h>
static int pick(int n)
{
    return ((int[]){7, 8, 9})[n]; // error: out of bounds
}
int main(void) { printf("%d\n", pick(0) + pick(PLANT(3, 2))); return 0; }
