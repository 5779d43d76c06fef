/* A histogram whose last bucket is one too far; another table lies behind it. */
#include <stdio.h>
static int bucket[4], other[64];
int main(void)
{
    int reading[] = {12, 3, 25, 31, 8}, i;
    for (i = 0; i < 5; i++)
        bucket[reading[i] / PLANT(6, 8)]++; // error: out of bounds
    printf("%d %d\n", bucket[0], other[0]);
    return 0;
}
