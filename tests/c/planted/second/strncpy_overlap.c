/* A word is moved to the right by strncpy. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char s[24] = "abcdef";
    if (PLANT(1, 0))
        strncpy(s + 2, s, 7); // error: overlapping copy
    else
        memmove(s + 2, s, 7);
    printf("%c\n", s[2]);
    return 0;
}
