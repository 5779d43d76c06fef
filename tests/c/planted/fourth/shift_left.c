/* Characters of a line move to the left in place. */
#include <stdio.h>
#include <string.h>

static void strip(char *line)
{
    size_t blanks = strspn(line, " ");

    if (blanks)
        PLANT(strcpy(line, line + blanks), // error: overlapping copy
              memmove(line, line + blanks, strlen(line + blanks) + 1));
}

int main(void)
{
    char line[] = "   forward";

    strip(line);
    puts(line);
    return 0;
}
