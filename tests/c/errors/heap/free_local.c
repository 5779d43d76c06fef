/* A local variable is given back. */
#include <stdlib.h>

int main(void)
{
    int n = 3;

    free(&n); // error: invalid free
    return 0;
}
