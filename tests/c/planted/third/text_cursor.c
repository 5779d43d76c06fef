/* A cursor in a fixed text jumps over the end of it. */
#include <stdio.h>
static char text[12] = "forward", page[500] = "left right forward";
int main(void)
{
    char *cursor = text;
    int jump = PLANT(60, 4);
    cursor += jump;
    *cursor = '!'; // error: out of bounds
    printf("%s %s\n", text, page);
    return 0;
}
