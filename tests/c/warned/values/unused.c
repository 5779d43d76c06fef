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
    a + b;  // warning: expression result unused
    a == next();  // warning: result of '==' unused
    strlen("abc");  // warning: ignoring return value of 'strlen', which has no side effects
    next;  // warning: write 'next()'
    for (a = 0; a < 3; a + 1)  // warning: expression result unused
//                     ^
        a++;
    b = (a - 1, 4);  // warning: expression result unused
    v;
    TRACE(a);
    (void)a;
    *p++;
    next();
    a && next();
    return (void)abs(b), a > 2 ? 0 : 1;
}
