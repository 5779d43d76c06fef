/* The result of realloc is thrown away. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    char *line = malloc(8), *longer;
    longer = realloc(line, 16);
    line = PLANT(line, longer);
    line[0] = 'x'; // error: use after free
    printf("%c\n", longer[0] == 'x' ? 'y' : 'n');
    free(longer);
    return 0;
}
