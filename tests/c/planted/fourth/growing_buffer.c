/* A buffer is doubled, and its new half is searched before it is filled. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void)
{
    char *buffer = malloc(8);
    int size = 8;

    memset(buffer, 'a', size);
    buffer = realloc(buffer, 2 * size);
    PLANT(, memset(buffer + size, 'b', size);)
    size *= 2;
    for (int i = 0; i < size; i++)
        if (buffer[i] == 'b') { // error: uninitialised read
            printf("%d\n", i);
            break;
        }
    free(buffer);
    return 0;
}
