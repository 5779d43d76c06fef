/* Example: some of the counters were never set. */
#include <stdio.h>

int main(void)
{
    int hits[5], i;

    for (i = 0; i < 5; i += 2)
        hits[i] = 0;
    for (i = 0; i < 5; i++)
        if (hits[i] > 0) // error: uninitialised read
            printf("%d\n", i);
    return 0;
}
