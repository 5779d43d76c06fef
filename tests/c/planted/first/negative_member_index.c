/* The index before the first element of an array in a struct. */
#include <stdio.h>
struct ring { int head; int item[4]; int tail; } ring = {3, {1, 2, 3, 4}, 5};
static int previous(int n) { return PLANT(n - 1, (n + 3) % 4); }
int main(void)
{
    int i, sum = 0, at = 2;
    for (i = 0; i < 4; i++) {
        sum += ring.item[at]; // error: out of bounds
        at = previous(at);
    }
    printf("%d\n", sum);
    return 0;
}
