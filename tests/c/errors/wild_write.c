/* An index that leads out of memory. */
#include <stdio.h>

static int table[10];

int main(void)
{
    int i = 400 * 1000 * 1000;

    table[3] = 7;
    table[i] = 1; // error: pointer outside memory
    return 0;
}
