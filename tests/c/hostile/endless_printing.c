/* Output without end. */
// ends: running
#include <stdio.h>

int main(void)
{
    unsigned n = 0;

    for (;;)
        printf("%u bottles of beer on the wall\n", n++);
}
