/* Absurd sizes: every one must fail, none may wrap around. */
// ends: exit 0
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    void *p = malloc(16);

    printf("%d", malloc(0xFFFFFFFFu) == 0);
    printf("%d", malloc(0xFFFFFFF0u) == 0);
    printf("%d", malloc(0x80000000u) == 0);
    printf("%d", malloc((unsigned) -9) == 0);
    printf("%d", calloc(0x10000, 0x10001) == 0);
    printf("%d", calloc(0x80000001u, 2) == 0);
    printf("%d", realloc(p, 0xFFFFFFFFu) == 0);
    printf("%d\n", realloc(p, 0xFFFFFFE8u) == 0);
    return 0;
}
