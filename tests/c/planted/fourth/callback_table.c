/* A table of handlers of which one has another parameter. */
#include <stdio.h>

typedef int handler(int);

static int turn(int angle)
{
    return angle * 2;
}

static int halt(PLANT(double, int) delay)
{
    return delay > 1;
}

int main(void)
{
    static handler *const handlers[] = {turn, (handler *)halt};
    int sum = 0;

    for (int i = 0; i < 2; i++)
        sum += handlers[i](3); // error: mismatched call
    printf("%d\n", sum);
    return 0;
}
