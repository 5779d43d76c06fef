/* A table in a function, with a value from outside. */
#include <stdio.h>
#include <stdlib.h>
static const char *name(int state)
{
    static const char *const names[] = {"stop", "go", "turn"};
    return names[state]; // error: out of bounds
}
int main(void)
{
    int i, n = 0;
    for (i = 0; i < PLANT(4, 3); i++)
        n += name(i)[0];
    printf("%d\n", n);
    return 0;
}
