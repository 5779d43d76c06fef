/* An output decided by nothing. */
#include <stdio.h>

int main(void)
{
    char text[8];

    text[0] = 'a';
    printf("%s\n", text); // error: uninitialised read
    return 0;
}
