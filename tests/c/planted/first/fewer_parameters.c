/* A table of commands; one of them takes another number of arguments. */
#include <stdio.h>
typedef int (*command)(int, int);
static int add(int a, int b) { return a + b; }
static int negate(int a) { return -a; }
static int minus(int a, int b) { (void)b; return -a; }
int main(void)
{
    command table[] = {add, PLANT((command)negate, minus)};
    int i, sum = 0;
    (void)negate;
    for (i = 0; i < 2; i++)
        sum += table[i](i, 2); // error: mismatched call
    printf("%d\n", sum);
    return 0;
}
