/* Unused values. */
#include <stdlib.h>
#include <string.h>

#define TRACE(x) (1 + (x))
static int next(void) { return 1; }

int main(void)
{
    int a = 1, b = 2, *p = &a;
    volatile int v = 3;

    a == b;  // warning: write '=' to assign
//  ^
    a + b;  // warning: this value is not used
    a == next();  // warning: the result of '==' is not used
    strlen("abc");  // warning: the value of 'strlen' is not used, and it does nothing else
    next;  // warning: write 'next()'
    for (a = 0; a < 3; a + 1)  // warning: this value is not used
//                     ^
        a++;
    b = (a - 1, 4);  // warning: this value is not used
    v;
    TRACE(a);
    (void)a;
    *p++;
    next();
    a && next();
    return (void)abs(b), a > 2 ? 0 : 1;
}
