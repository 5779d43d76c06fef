/* A block is given back twice. */
#include <stdlib.h>

int main(void)
{
    char *p = malloc(10), *q = p;

    free(p);
    free(q); // error: double free
    return 0;
}
