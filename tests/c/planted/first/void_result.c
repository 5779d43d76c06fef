/* A function without a result is called for one. */
#include <stdio.h>
static int total;
static void count(int n) { total += n; }
static int tally(int n) { return total += n; }
int main(void)
{
    int (*f)(int) = PLANT((int (*)(int))count, tally);
    (void)count;
    total = 1;
    if (f(2) > 2) // error: mismatched call
        puts("many");
    return 0;
}
