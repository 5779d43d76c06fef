/* Leading blanks are removed with strcpy. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char line[20] = "  forward", *p = line;
    while (*p == ' ')
        p++;
    if (PLANT(1, 0))
        strcpy(line, p); // error: overlapping copy
    else
        memmove(line, p, strlen(p) + 1);
    puts(line);
    return 0;
}
