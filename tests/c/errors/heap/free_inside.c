/* A pointer into a block is given back. */
#include <stdlib.h>

int main(void)
{
    char *p = malloc(100);

    free(p + 48); // error: invalid free
    return 0;
}
