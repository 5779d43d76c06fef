/* A frame that is larger than the whole stack. */
#include <stdio.h>

static int big(void) // error: stack overflow
{
    char space[3 * 1024 * 1024];

    space[0] = 1;
    return space[0];
}

int main(void)
{
    printf("before\n");
    return big();
}
