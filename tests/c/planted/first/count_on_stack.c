/* A counter in an array is increased. */
#include <stdio.h>
static int count(const char *s)
{
    int seen[26] PLANT(, = {0}), n = 0;
    for (; *s; s++)
        seen[*s - 'a']++; // error: uninitialised read
    if (seen[2] > 1)
        n = 1;
    return n;
}
int main(void)
{
    printf("%d\n", count("cocoa"));
    return 0;
}
