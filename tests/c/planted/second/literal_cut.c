/* The end of a line is cut off, and the line is a literal. */
#include <stdio.h>
#include <string.h>
static char kept[32] = "forward\n";
int main(void)
{
    char *line = PLANT("forward\n", kept), *end = strchr(line, '\n');
    if (end)
        *end = 0; // error: write to read-only memory
    puts(line);
    return 0;
}
