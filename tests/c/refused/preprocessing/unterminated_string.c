/* A string without end. */
#include <stdio.h>

int main(void)
{
    printf("no end); // error: 
    return 0;
}
