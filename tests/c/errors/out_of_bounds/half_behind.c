/* An int of which only the first bytes lie in the block. */
#include <stdlib.h>

int main(void)
{
    char *p = malloc(6);

    *(int *) (p + 4) = 1; // error: out of bounds
    return 0;
}
