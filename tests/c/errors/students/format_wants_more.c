/* Example: the format expects two numbers, but the call passes one. */
#include <stdio.h>

int main(void)
{
    int found = 3;

    printf("%d of %d\n", found); // error: missing argument
    return 0;
}
