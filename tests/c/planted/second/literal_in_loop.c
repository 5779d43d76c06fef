/* Compound literals of a loop's body are kept in a table. */
#include <stdio.h>
struct step { int length; };
int main(void)
{
    struct step one = {1}, *plan[3];
    int i, sum = 0;
    for (i = 0; i < 3; i++) {
        plan[i] = PLANT(&(struct step){i}, &one);
    }
    for (i = 0; i < 3; i++)
        sum += plan[i]->length; // error: use after scope
    printf("%d\n", sum);
    return 0;
}
