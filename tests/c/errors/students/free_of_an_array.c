/* Not everything is the heap's. */
#include <stdlib.h>

static int table[4];

int main(void)
{
    int *values = table;

    values[0] = 1;
    free(values); // error: invalid free
    return 0;
}
