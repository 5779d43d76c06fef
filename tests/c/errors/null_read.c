/* Reading through a null pointer. */
#include <stdio.h>

static int first(const int *values)
{
    return *values; // error: null pointer
}

int main(void)
{
    int one = 1;

    printf("%d\n", first(&one));
    printf("%d\n", first(0));
    return 0;
}
