/* The length of a token whose end lies in the line that was read before. */
#include <stdio.h>
#include <string.h>
static char lines[2][32];
struct line { char *text; };
int main(void)
{
    char *held = 0, buffer[32];
    struct line line;
    strcpy(buffer, "speed 12");
    strcpy(lines[0], "turn 90");
    line.text = PLANT(lines[0], buffer);
    held = strchr(buffer, ' ');
    if (held - line.text < 20) // error: unrelated pointers
        puts("short");
    return 0;
}
