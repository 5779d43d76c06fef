/* A string is appended to itself. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char word[40] = "beep", copy[40];
    strcpy(copy, word);
    strcat(word, PLANT(word + 1, copy)); // error: overlapping copy
    puts(word);
    return 0;
}
