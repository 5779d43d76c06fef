/* The library is given a block that was freed. */
#include <stdlib.h>
#include <string.h>

int main(void)
{
    char *s = strdup("hello");

    free(s);
    return strlen(s); // error: use after free
}
