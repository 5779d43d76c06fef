/* A function of a double result is called as one of int. */
#include <stdio.h>
static double half(int n) { return n / 2.0; }
static int twice(int n) { return n * 2; }
int main(void)
{
    int (*f)(int) = PLANT((int (*)(int))half, twice);
    (void)half;
    printf("%d\n", f(4)); // error: mismatched call
    return 0;
}
