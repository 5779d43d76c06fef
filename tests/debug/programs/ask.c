/* Reads numbers, a line each, and adds them up. */
#include <stdio.h>

int main(void)
{
    int number, sum = 0;

    while (scanf("%d", &number) == 1)
        sum += number;
    printf("the sum is %d\n", sum);
    return sum == 0;
}
