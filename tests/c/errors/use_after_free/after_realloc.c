/* The old pointer after the block has moved. */
#include <stdlib.h>

int main(void)
{
    char *old = malloc(16), *between = malloc(16), *grown;

    old[0] = 'a';
    grown = realloc(old, 1000);
    grown[1] = 'b';
    return old[0] + (between == NULL); // error: use after free
}
