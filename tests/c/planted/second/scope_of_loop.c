/* The address of a loop's variable outlives the loop. */
#include <stdio.h>
int main(void)
{
    int zero = 0, *p = &zero;
    for (int i = 0; i < 3; i++)
        p = PLANT(&i, &zero);
    printf("%d\n", *p); // error: use after scope
    return 0;
}
