/* sprintf writes more than the buffer holds. */
#include <stdio.h>

int main(void)
{
    char text[8];

    sprintf(text, "%d %d", 12345, 6789); // error: out of bounds
    return 0;
}
