/* Quotes and dashes that a word processor made: “these” – are fine in a comment. */
#include <stdio.h>

int main(void)
{
    printf(“hello, %d\n”, 3); // error: write "
    printf("hello”); // error: instead of
    char c = ‘a’; // error: write '
    c = ‘\n’; // error: write '
    c = 3 – 2; // error: write -
    puts("“fine” – here");
    return c;
}
