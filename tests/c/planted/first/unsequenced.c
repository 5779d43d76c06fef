/* A variable is changed twice between two sequence points. */
#include <stdio.h>
int main(void)
{
    int i = 3;
    i = PLANT(i++, i) + 1; // warning: unsequenced
    printf("%d\n", i);
    return 0;
}
