/* The format speaks of a string where a number is. */
#include <stdio.h>

int main(void)
{
    int distance = 12;

    printf("distance %s\n", (char *)distance); // error: null pointer
    return 0;
}
