/* Two fingers that walk towards each other start in two copies of a word. */
#include <stdio.h>
#include <string.h>
#include <stdlib.h>
static void reverse(char *from, char *to)
{
    while (from < to) { // warning: pointers to different objects
        char c = *from;
        *from++ = *to;
        *to-- = c;
    }
}
int main(void)
{
    char *one = strdup("robot"), *two = strdup("robot");
    reverse(one, PLANT(two, one) + strlen(one) - 1);
    puts(one);
    free(one);
    free(two);
    return 0;
}
