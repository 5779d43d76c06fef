/* continue ends the block of an iteration. */
#include <stdio.h>
int main(void)
{
    int i, sum = 0, zero = 0, *last = &zero;
    for (i = 0; i < 4 && *last >= 0; i++) { // error: use after scope
        int here = i;
        last = PLANT(&here, &zero);
        if (i % 2)
            continue;
        sum++;
    }
    printf("%d\n", sum);
    return 0;
}
