/* Example: a string literal cannot be modified. */
#include <ctype.h>
#include <stdio.h>

static void capitalise(char *word)
{
    word[0] = toupper(word[0]); // error: write to read-only memory
}

int main(void)
{
    char mine[] = "left", *theirs = "right";

    capitalise(mine);
    puts(mine);
    capitalise(theirs);
    puts(theirs);
    return 0;
}
