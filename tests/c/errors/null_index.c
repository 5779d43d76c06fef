/* An element of an array that is not there. */
#include <stdio.h>

int main(void)
{
    short *readings = 0;
    int i, sum = 0;

    for (i = 0; i < 100; i++)
        sum += readings[i]; // error: null pointer
    printf("%d\n", sum);
    return 0;
}
