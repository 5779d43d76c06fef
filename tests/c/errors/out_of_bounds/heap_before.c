/* The word before a block of the heap, where the allocator keeps its own. */
#include <stdlib.h>

int main(void)
{
    int *p = malloc(40);

    return p[-1]; // error: out of bounds
}
