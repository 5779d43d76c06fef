/* A freed block is to grow. */
#include <stdlib.h>

int main(void)
{
    int *p = malloc(40);

    free(p);
    p = realloc(p, 80); // error: double free
    return p != NULL;
}
