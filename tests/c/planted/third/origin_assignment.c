/* A member without a value goes through an assignment and a call. */
#include <stdio.h>
struct goal { int x, y, heading; };
static struct goal current;
static int heading_of(struct goal g)
{
    return g.heading + 1; // error: uninitialised read
}
int main(void)
{
    struct goal wanted; // origin
    wanted.x = 1;
    wanted.y = 2;
    PLANT(, wanted.heading = 3);
    current = wanted;
    printf("%d\n", heading_of(current) > 0);
    return 0;
}
