/* Constant array indices out of bounds. */
#include <stdio.h>

struct tail { int count; char data[1]; };
static int table[4][2];

int main(void)
{
    int a[3] = {1, 2, 3}, *end = &a[3];
    struct tail t = {1, "x"}, *p = &t;

    if (end == a) {
        a[3] = 1;  // warning: array index 3 is outside the bounds of 'int[3]'
//      ^
        a[-1] = 1;  // warning: valid indices are 0 to 2
        table[5][0] = 1;  // warning: array index 5 is outside the bounds of 'int[4][2]'
        table[3][2] = 1;  // warning: array index 2 is outside the bounds of 'int[2]'
        p->data[5] = 1;
        *(a + 7) = 1;  // warning: array index 7 is outside the bounds of 'int[3]'
    }
    printf("%d %u\n", a[2], (unsigned)sizeof a[9]);
    return 0;
}
