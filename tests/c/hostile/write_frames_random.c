/* Scatters random words over its stack and goes on calling, printing and recursing. */
// ends: any
#include <stdio.h>

static unsigned seed = 1;

static unsigned next(void)
{
    return seed = seed * 1664525u + 1013904223u;
}

static int wander(int depth)
{
    int here[2];

    here[(int) (next() >> 16) % 200] = next() >> 3;
    if (next() >> 28 == 0)
        printf("%d\n", depth);
    if (depth > 0)
        return wander(depth - 1) + wander(depth - 1);
    return here[0];
}

int main(void)
{
    for (;;)
        wander(12);
}
