/* while, do and for in all their forms; break and continue. */
#include <stdio.h>

int main(void)
{
    int i = 0, j, n = 0;
    const char *s;

    while (i < 3)
        i++;
    do
        n += i;
    while (--i);
    printf("%d %d\n", i, n);
    for (;;) {
        if (++i == 4)
            continue;
        if (i > 6)
            break;
        printf("%d ", i);
    }
    printf("\n");
    for (i = 10; i--;)
        if (i % 3)
            continue;
        else
            printf("%d ", i);
    printf("\n");
    do {
        if (i < 5)
            continue;
        printf("never\n");
    } while (++i < 5);
    printf("%d\n", i);
    for (int i = 0, k = 9; i < k; i += 2, k--)
        printf("%d-%d ", i, k);
    printf("%d\n", i);
    for (s = "abc"; *s; ++s)
        for (j = 0; j < 3; j++) {
            if (j == *s - 'a')
                break;
            printf("%c%d ", *s, j);
        }
    printf("\n");
    while (n-- > 0)
        while (n & 1)
            n--;
    printf("%d\n", n);
    for (i = 0; i < 100; i++)
        ;
    do ; while (0);
    do { break; } while (1);
    for (float x = 0; x < 1; x += 0.25f)
        printf("%g ", x);
    printf("%d\n", i);
    return 0;
}
