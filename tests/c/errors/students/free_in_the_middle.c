/* Example: the pointer that malloc returned has been advanced. */
#include <stdlib.h>
#include <string.h>

int main(void)
{
    char *words = malloc(20);

    strcpy(words, "turn left");
    while (*words != ' ')
        words++;
    free(words); // error: invalid free
    return 0;
}
