/* Nothing ends the search at the start of the array. */
#include <stdio.h>

int main(void)
{
    int history[8] = { 5, 7, 9 }, last = 2;

    while (history[last] != 3) // error: out of bounds
        last--;
    printf("%d\n", last);
    return 0;
}
