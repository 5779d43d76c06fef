/* Example: a pointer to a small array reaches far into a large one. */
#include <stdio.h>

static int scan[6] = {3, 1, 4, 1, 5, 9};
static int map[200];

int main(void)
{
    const int *nearest = scan;
    int i, sum = 0;

    for (i = 0; i < 80; i += 20)
        sum += nearest[i]; // error: out of bounds
    printf("%d\n", sum + map[0]);
    return 0;
}
