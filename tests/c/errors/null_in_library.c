/* The library reads through the pointer that it was given; the program stops there. */
#include <string.h>

int main(void)
{
    char buffer[8];

    strcpy(buffer, 0); // error: null pointer
    return buffer[0];
}
