/* A function of a float is called as one of a double. */
#include <stdio.h>
static double wide(double x) { return x * 2; }
static float narrow(float x) { return x * 2; }
int main(void)
{
    double (*f)(double) = PLANT((double (*)(double))narrow, wide);
    (void)narrow, (void)wide;
    printf("%g\n", f(1.5)); // error: mismatched call
    return 0;
}
