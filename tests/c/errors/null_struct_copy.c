/* Copying a whole struct from a null pointer. */
#include <stdio.h>

struct pose { double x, y, heading; };

int main(void)
{
    struct pose here = { 1, 2, 3 }, *there = 0;

    here = *there; // error: null pointer
    printf("%g\n", here.x);
    return 0;
}
