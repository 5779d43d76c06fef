/* A pointer to the front of a block that was cut down. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(void)
{
    char *text = malloc(100), *start = text;
    strcpy(text, "short");
    text = realloc(text, 6);
    if (PLANT(1, 0))
        start[0] = 'S'; // error: use after free
    puts(text);
    free(text);
    return 0;
}
