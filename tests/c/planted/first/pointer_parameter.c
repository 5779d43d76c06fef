/* A function that wants an address is given a number. */
#include <stdio.h>
static int length(const char *s) { int n = 0; while (*s++) n++; return n; }
static int same(int n) { return n; }
int main(void)
{
    int (*measure)(int) = PLANT((int (*)(int))length, same);
    (void)length;
    printf("%d\n", measure(100000)); // error: mismatched call
    return 0;
}
