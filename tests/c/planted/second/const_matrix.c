/* A constant matrix is cleared. */
#include <stdio.h>
#include <string.h>
static const double unit[2][2] = {{1, 0}, {0, 1}};
static double own[2][2];
int main(void)
{
    memset(PLANT((void *)unit, own), 0, sizeof own); // error: write to read-only memory
    printf("%g\n", unit[0][0]);
    return 0;
}
