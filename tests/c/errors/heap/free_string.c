/* A string literal is given back. */
#include <stdlib.h>

int main(void)
{
    char *s = "text";

    free(s); // error: invalid free
    return 0;
}
