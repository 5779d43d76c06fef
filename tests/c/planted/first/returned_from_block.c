/* The address of a variable in an inner block is returned. */
#include <stdio.h>
static int keep;
static int *make(int n)
{
    int *p = &keep;
    if (n) {
        int local = n;
        p = PLANT(&local, p);
        return p;
    }
    return p;
}
int main(void)
{
    int *p = make(4);
    printf("%d\n", *p); // error: use after return
    return 0;
}
