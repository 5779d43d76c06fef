/* The division is in a small function called by another one. */
#include <stdio.h>

static int share(int total, int parts)
{
    return total / parts;  // error: division by zero
}

static int twice_the_share(int total, int parts)
{
    return 2 * share(total, parts);
}

int main(void)
{
    int parts, total = 0;
    for (parts = 2; parts >= 0; parts--)
        total += twice_the_share(100, parts);
    printf("%d\n", total);
    return 0;
}
