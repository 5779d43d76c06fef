/* A format asks for more than was passed. */
#include <stdio.h>

int main(void)
{
    printf("%d %d\n", 1); // error: missing argument
    return 0;
}
