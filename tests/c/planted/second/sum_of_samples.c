/* A sum of samples in an int overflows. */
#include <stdio.h>
int main(void)
{
    int sum = 0, i;
    for (i = 0; i < PLANT(50000, 50); i++)
        sum += 65536; // error: signed overflow
    printf("%d\n", sum > 0);
    return 0;
}
