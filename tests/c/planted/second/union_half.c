/* Only half of a union was set. */
#include <stdio.h>
union cell { char byte[4]; int word; };
int main(void)
{
    union cell c;
    int i;
    for (i = 0; i < PLANT(3, 4); i++)
        c.byte[i] = i;
    if (c.word & 0x01000000) // error: uninitialised read
        puts("set");
    return 0;
}
