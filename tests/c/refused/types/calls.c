/* Calls and members that do not exist, told with those that do. */
#include <string.h>
struct point { int x, y; };
static int sum(int a, int b);
int main(void)
{
    struct point p = {1, 2};
    double *d = 0;
    sum(1);  // error: 'sum' is declared at
    sum(1, 2, 3);  // error: too many arguments to function call, expected 2, have 3
//  ^
    strlen();  // error: expected 1, have 0
    p.z = 1;  // error: its members are x, y
//    ^
    return *d % 2;  // error: invalid operands to binary expression ('double' and 'int')
//         ^
}
static int sum(int a, int b) { return a + b; }
