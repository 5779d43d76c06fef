/* Weak definitions are overridden by those of another file. */
#include <stdio.h>
__attribute__((weak)) int speed(void) { return 1; }
int __attribute__((weak)) limit = 10;
__attribute__((weak)) int own(void) { return 5; }
int main(void)
{
    printf("%d %d %d\n", speed(), limit, own());
    return 0;
}
