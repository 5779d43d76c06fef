/* The length of a field is the difference of pointers into different buffers. */
#include <stdio.h>
#include <string.h>

static char input[40] = "speed=42", name[40];

int main(void)
{
    char *end = strchr(input, '=');
    int length;

    strcpy(name, input);
    length = end - PLANT(name, input); // error: unrelated pointers
    name[length] = '\0';
    puts(name);
    return 0;
}
