/* Example: sixteen sonars are numbered from 0 to 15. */
#include <stdio.h>

static int order[16];

static int closest(const int *sonar, int count)
{
    int i, best = 0;

    for (i = 1; i <= count; i++)
        if (sonar[i] < sonar[best]) // error: out of bounds
            best = i;
    return best;
}

int main(void)
{
    int i;

    for (i = 0; i < 16; i++)
        order[i] = 255 - i;
    printf("%d\n", closest(order, 16));
    return 0;
}
