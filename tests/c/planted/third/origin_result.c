/* What a function returns has a member that it did not set on one way. */
#include <stdio.h>
struct reading { int distance; int valid; };
static struct reading measure(int sensor)
{
    struct reading r; // origin
    r.valid = sensor < PLANT(4, 99);
    if (r.valid)
        r.distance = sensor * 10;
    return r;
}
int main(void)
{
    struct reading all[6];
    int i, sum = 0;
    for (i = 0; i < 6; i++)
        all[i] = measure(i);
    for (i = 0; i < 6; i++)
        sum += all[i].distance; // error: uninitialised read
    printf("%d\n", sum);
    return 0;
}
