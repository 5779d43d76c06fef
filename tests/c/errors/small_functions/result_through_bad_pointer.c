/* A struct that a small function returns goes to an address that is not valid. */
#include <stdio.h>

struct point { double x, y; };

static struct point moved(struct point from, double by)  // error: null pointer (anywhere)
{
    struct point to = { from.x + by, from.y + by };
    return to;
}

int main(void)
{
    struct point here = { 1, 2 }, *target = &here;
    int i;
    for (i = 0; i < 3; i++) {
        *target = moved(here, 1);
        target = i == 1 ? 0 : &here;
    }
    printf("%g\n", here.x);
    return 0;
}
