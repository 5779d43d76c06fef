/* One byte behind a block of the heap. */
#include <stdlib.h>

int main(void)
{
    char *p = malloc(10);

    p[10] = 0; // error: out of bounds
    return 0;
}
