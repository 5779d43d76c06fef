/* Writes to a block that was given back. */
#include <stdlib.h>

int main(void)
{
    double *d = malloc(80);

    free(d);
    d[3] = 1; // error: use after free
    return 0;
}
