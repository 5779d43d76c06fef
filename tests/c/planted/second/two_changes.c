/* A position is moved twice in one expression. */
#include <stdio.h>
int main(void)
{
    char out[4] = "abc";
    int n = 0;
    out[n] = out[PLANT(n++, n + 1)]; // warning: unsequenced
    printf("%s %d\n", out, n);
    return 0;
}
