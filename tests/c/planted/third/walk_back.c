/* A pointer walks back through a row of readings, too far. */
#include <stdio.h>
static double before[60], row[8] = {1, 2, 3, 4, 5, 6, 7, 8};
int main(void)
{
    const double *p = &row[7];
    double sum = before[0];
    int step = PLANT(29, 3), i;
    for (i = 0; i < 2; i++, p -= step)
        sum += *p; // error: out of bounds
    printf("%.1f\n", sum);
    return 0;
}
