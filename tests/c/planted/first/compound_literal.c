/* A compound literal ends with its block. */
#include <stdio.h>
struct point { int x, y; };
int main(void)
{
    struct point zero = {0, 0}, *p = &zero;
    if (zero.x == 0) {
        struct point *q = &(struct point){3, 4};
        p = PLANT(q, p);
    }
    printf("%d\n", p->x); // error: use after scope
    return 0;
}
