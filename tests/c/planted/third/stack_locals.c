/* The direction in which the stack grows is no business of C's. */
#include <stdio.h>
static int grows_down(int *outer)
{
    int inner[2] = {0, 0}, *mine = PLANT(inner, outer + 1);
    return mine < outer ? *mine : 1; // warning: pointers to different objects
}
int main(void)
{
    int first[2] = {0, 0};
    printf("%d\n", grows_down(first) >= 0);
    return 0;
}
