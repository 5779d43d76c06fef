/* break leaves a block inside a switch. */
#include <stdio.h>
static int pick(int n)
{
    int zero = 0, *p = &zero;
    switch (n) {
    case 1: {
        int one = 1;
        p = PLANT(&one, &zero);
        break;
    }
    default:
        break;
    }
    return *p; // error: use after scope
}
int main(void)
{
    printf("%d\n", pick(2));
    printf("%d\n", pick(1));
    return 0;
}
