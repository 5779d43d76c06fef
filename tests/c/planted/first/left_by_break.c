/* break leaves the block of the variable. */
#include <stdio.h>
int main(void)
{
    int i, zero = 0, *found = &zero;
    for (i = 0; i < 10; i++) {
        int square = i * i;
        if (square > 20) {
            found = PLANT(&square, found);
            break;
        }
    }
    if (*found > 3) // error: use after scope
        puts("found");
    return 0;
}
