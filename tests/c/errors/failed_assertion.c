/* A failed assertion prints its condition to stderr. */
#include <assert.h>
#include <stdio.h>

static int checked(int n)
{
    assert(n < 3); // error: assertion failed
    return n;
}

int main(void)
{
    int i;

    for (i = 0; i < 5; i++)
        printf("%d\n", checked(i));
    return 0;
}
