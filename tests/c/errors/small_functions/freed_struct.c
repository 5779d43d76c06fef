/* A small function is passed a struct by value, from a block that was freed. */
#include <stdio.h>
#include <stdlib.h>

struct point { double x, y; };

static double product(struct point a, struct point b)
{
    return a.x * b.x + a.y * b.y;
}

int main(void)
{
    struct point *points = malloc(2 * sizeof *points), here = { 1, 2 };
    double sum = 0;
    int i;

    points[0] = points[1] = here;
    for (i = 0; i < 3; i++) {
        sum += product(points[1], here);  // error: use after free
        if (i == 1)
            free(points);
    }
    printf("%g\n", sum);
    return 0;
}
