/* An index that leads out of memory. */
#include <stdio.h>

static int table[10], *at = table;

int main(void)
{
    int i = 400 * 1000 * 1000;

    table[3] = 7;
    at[i] = 1; // error: pointer outside memory
    return 0;
}
