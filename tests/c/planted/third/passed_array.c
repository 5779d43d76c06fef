/* A small function that is passed an array that is too short for it. */
#include <stdio.h>
static int left[4] = {1, 2, 3, 4}, right[64]; // origin
static int at(const int *from, int i) { return from[i]; } // error: out of bounds
int main(void)
{
    right[20] = 4;
    printf("%d\n", at(left, PLANT(24, 2)) + right[1]);
    return 0;
}
