/* An integer is given back. */
#include <stdlib.h>

int main(void)
{
    free((void *) 0x1234560); // error: invalid free
    return 0;
}
