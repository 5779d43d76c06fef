/* A callee reads what a block has left. */
#include <stdio.h>
static int read(const int *p) { return *p; } // error: use after scope
int main(void)
{
    int other = 4;
    const int *p;
    if (other > 3) {
        int inner = other * 2;
        p = PLANT(&inner, &other);
    } else
        p = &other;
    printf("%d\n", read(p));
    return 0;
}
