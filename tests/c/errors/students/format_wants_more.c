/* Example: two numbers are announced, one is given. */
#include <stdio.h>

int main(void)
{
    int found = 3;

    printf("%d of %d\n", found); // error: missing argument
    return 0;
}
