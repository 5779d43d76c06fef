/* The value of a void expression. */
#include <stdlib.h>

int main(void)
{
    int n = free(0); // error: void

    return n;
}
