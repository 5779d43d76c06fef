/* strtok cuts a literal. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char line[] = "go 10 20";
    char *text = PLANT("go 10 20", line);
    char *word = strtok(text, " "); // error: write to read-only memory
    puts(word);
    return 0;
}
