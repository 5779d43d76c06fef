/* A line is read into a literal. */
#include <stdio.h>
#include <string.h>
static char room[8];
int main(void)
{
    char *to = PLANT("       ", room);
    strncpy(to, "abc", 7); // error: write to read-only memory
    puts(to);
    return 0;
}
