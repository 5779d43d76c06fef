/* Letters are counted, and a capital comes. */
#include <stdio.h>
static unsigned short seen[26];
static unsigned short words[100];
int main(void)
{
    const char *s = PLANT("a Mouse", "a mouse");
    for (; *s; s++)
        if (*s != ' ')
            seen[*s - 'a']++; // error: out of bounds
    printf("%d\n", seen[0] + words[2]);
    return 0;
}
