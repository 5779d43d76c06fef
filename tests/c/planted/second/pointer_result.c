/* A function that returns a number is called for an address. */
#include <stdio.h>
static char text[] = "text";
static char *get(int n) { return text + n; }
static int number(int n) { return n; }
int main(void)
{
    char *(*f)(int) = PLANT((char *(*)(int))number, get);
    (void)number, (void)get;
    printf("%d\n", f(0) == text); // error: mismatched call
    return 0;
}
