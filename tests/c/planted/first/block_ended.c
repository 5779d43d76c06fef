/* A pointer to a variable of a block, used behind it. */
#include <stdio.h>
int main(void)
{
    int outer = 1, *p = &outer;
    {
        int inner = 2;
        p = PLANT(&inner, p);
        *p += 1;
    }
    printf("%d\n", *p + outer); // error: use after scope
    return 0;
}
