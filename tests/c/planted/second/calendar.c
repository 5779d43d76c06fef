/* Days of a month by its number from 1 to 12. */
#include <stdio.h>
static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
static int before(int month)
{
    int m, sum = 0;
    for (m = 1; m < month; m++)
        sum += days[PLANT(m, m - 1)]; // error: out of bounds
    return sum;
}
int main(void) { printf("%d\n", before(13)); return 0; }
