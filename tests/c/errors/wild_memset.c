/* A block operation that runs over the end of memory. */
#include <string.h>

static char buffer[16];

int main(void)
{
    memset(buffer, 1, 2000000000u); // error: out of bounds
    return 0;
}
