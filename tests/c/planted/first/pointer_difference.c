/* The length of a word is computed from pointers into two buffers. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char line[32] = "turn right", copy[32], *space;
    strcpy(copy, line);
    space = strchr(PLANT(copy, line), ' ');
    printf("%d\n", space - line > 3); // error: unrelated pointers
    return 0;
}
