/* The zero behind a string has no room. */
#include <stdlib.h>
#include <string.h>

int main(void)
{
    const char *name = "wander";
    char *copy = malloc(strlen(name));

    strcpy(copy, name); // error: out of bounds
    return 0;
}
