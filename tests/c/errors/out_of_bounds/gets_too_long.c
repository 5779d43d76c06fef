/* fgets is told of more room than there is. */
#include <stdio.h>
#include <string.h>

static void fill(char *to, int size)
{
    memset(to, 'x', size); // error: out of bounds
}

int main(void)
{
    char line[20];

    fill(line, 80);
    return 0;
}
