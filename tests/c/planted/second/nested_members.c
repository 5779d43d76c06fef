/* An array in a struct in an array of structs. */
#include <stdio.h>
struct leg { short angle[3]; short load; };
static struct { struct leg leg[2]; int id; } robot;
int main(void)
{
    int l, j;
    for (l = 0; l < 2; l++)
        for (j = PLANT(3, 2); j >= 0; j--)
            robot.leg[l].angle[j] = 90; // error: out of bounds
    printf("%d\n", robot.leg[1].angle[0]);
    return 0;
}
