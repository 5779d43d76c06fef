/* The end of a block at a large alignment is where the program asked for it. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    char *block = aligned_alloc(256, 100);
    int i;

    for (i = 0; i <= 100; i++)
        block[i] = 'x'; // error: out of bounds
    printf("%c\n", block[0]);
    return 0;
}
