/* Example: strcpy within one string. */
#include <stdio.h>
#include <string.h>

int main(void)
{
    char line[] = "  forward";

    strcpy(line, line + 2); // error: overlapping copy
    puts(line);
    return 0;
}
