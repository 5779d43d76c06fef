/* A block is replaced by another and never freed. */
#include <stdlib.h>
static char *name;
int main(void)
{
    name = malloc(10); // leak: 1
    PLANT(, free(name));
    name = malloc(20);
    name[0] = 0;
    return 0;
}
