/* Example: an array that is local to a function that has returned. */
#include <stdio.h>

static char *name_of(int state)
{
    char text[20];
    char *result = text;

    sprintf(text, "state %d", state);
    return result;
}

int main(void)
{
    char *name = name_of(3);

    puts(name); // error: use after return
    return 0;
}
