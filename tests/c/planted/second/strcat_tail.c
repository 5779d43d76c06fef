/* The tail of a string is appended to it. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char s[40] = "left-right", tail[40];
    strcpy(tail, s + 4);
    strncat(s, PLANT(s + 4, tail), 20); // error: overlapping copy
    puts(s);
    return 0;
}
