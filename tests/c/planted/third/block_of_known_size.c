/* Of two blocks the first is written far behind its end. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    short *wheel = malloc(10 * sizeof *wheel), *other = malloc(400 * sizeof *other);
    int i, n = PLANT(90, 9);
    for (i = 0; i < 400; i++)
        other[i] = 1;
    for (i = 0; i < 10; i++)
        wheel[i] = 2;
    *(wheel + n) = 3; // error: out of bounds
    printf("%d\n", other[0]);
    free(wheel);
    free(other);
    return 0;
}
