/* A number is put before the text that is already there. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char line[40] = "ready", copy[40];
    strcpy(copy, line);
    snprintf(line, sizeof line, "%d: %s", 12, PLANT(line, copy)); // error: overlapping copy
    puts(line);
    return 0;
}
