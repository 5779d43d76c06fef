/* Index and array exchanged, as C allows. */
#include <stdio.h>
static int gear[5] = {0, 10, 20, 40, 80}, other[50];
int main(void)
{
    int g = 0;
    while (g < PLANT(20, 4))
        g++;
    printf("%d\n", g[gear] + other[0]); // error: out of bounds
    return 0;
}
