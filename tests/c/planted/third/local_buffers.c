/* Two buffers on the stack, one written through a pointer to the other. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    int small[4], large[80], *p = small, k;
    memset(small, 0, sizeof small);
    memset(large, 0, sizeof large);
    for (k = 0; k < PLANT(60, 4); k += PLANT(20, 1))
        p[k] = k; // error: out of bounds
    printf("%d %d\n", small[0], large[5]);
    return 0;
}
