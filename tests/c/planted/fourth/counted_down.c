/* A loop with an unsigned counter that never is below zero. */
#include <stdio.h>

static const int weights[] = {1, 2, 3, 4};

int main(void)
{
    int sum = 0;

    for (unsigned i = 3; PLANT(i >= 0, i != -1u); i--)
        sum += weights[i] * 10; // error: out of bounds
    printf("%d\n", sum);
    return 0;
}
