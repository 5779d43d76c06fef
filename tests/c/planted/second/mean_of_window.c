/* The sum of a window that is only half full. */
#include <stdio.h>
static double mean(const double *w, int n)
{
    double s = 0;
    int i;
    for (i = 0; i < n; i++)
        s += w[i]; // error: uninitialised read
    return s / n;
}
int main(void)
{
    double window[5];
    int i;
    for (i = 0; i < 3; i++)
        window[i] = i;
    printf("%g\n", mean(window, PLANT(5, 3)));
    return 0;
}
