/* A text that was never set is reversed byte by byte: the report names its heap block. */
#include <stdlib.h>

int main(void)
{
    char *text = malloc(6), *reversed = malloc(6);
    int i;

    for (i = 0; i < 6; i++)
        reversed[5 - i] = text[i];
    return reversed[2] == 'x'; // error: uninitialised read
}
