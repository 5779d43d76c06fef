/* A string literal is changed in place. */
#include <ctype.h>
#include <stdio.h>
static void upper(char *s)
{
    for (; *s; s++)
        *s = toupper(*s); // error: write to read-only memory
}
int main(void)
{
    char copy[] = "left";
    char *word = PLANT("left", copy);
    upper(word);
    puts(word);
    return 0;
}
