/* A struct passed by value has a member that nobody set. */
#include <stdio.h>
struct pose { int x, y, theta; };
static int turn(struct pose p)
{
    if (p.theta > 180) // error: uninitialised read
        return -1;
    return 1;
}
int main(void)
{
    struct pose p;
    p.x = 1;
    p.y = 2;
    PLANT(, p.theta = 3);
    printf("%d\n", turn(p));
    return 0;
}
