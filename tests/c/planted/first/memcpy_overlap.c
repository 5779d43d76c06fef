/* An array is shifted with memcpy. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    int history[6] = {1, 2, 3, 4, 5, 6};
    PLANT(memcpy, memmove)(history + 1, history, 5 * sizeof(int)); // error: overlapping copy
    history[0] = 0;
    printf("%d\n", history[5]);
    return 0;
}
