/* A string without its zero is read to its end and beyond. */
#include <string.h>

int main(void)
{
    char letters[3] = { 'a', 'b', 'c' };

    return strlen(letters); // error: out of bounds
}
