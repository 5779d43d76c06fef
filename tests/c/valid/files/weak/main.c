/* Weak definitions are overridden by ordinary definitions in another file. */
#include <stdio.h>
__attribute__((weak)) int speed(void) { return 1; }
int __attribute__((weak)) limit = 10;
__attribute__((weak)) int own(void) { return 5; }
#pragma weak turn
int turn(void) { return 6; }
#pragma weak back = own
int back(void);
#pragma weak aside = own
int named_elsewhere(void);
int main(void)
{
    printf("%d %d %d\n", speed(), limit, own());
    printf("%d %d %d\n", turn(), back(), named_elsewhere());
    return 0;
}
