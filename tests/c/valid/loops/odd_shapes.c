/* Loops without bodies, without clauses, with commas, with continue and goto inside switches. */
#include <stdio.h>

#define SWAP(a, b) do { int t = (a); (a) = (b); (b) = t; } while (0)

int main(void)
{
    const char *text = "count me";
    int n = 0, i, j, sum = 0;

    for (const char *p = text; *p++; n++);
    printf("%d\n", n);
    for (i = 0, j = 10; i < j; i += 2, j--);
    printf("%d %d\n", i, j);
    for (;;)
        if (++sum > 4)
            break;
    while (n --> 0)
        ;
    printf("%d %d\n", sum, n);
    do
        sum *= 2;
    while (sum < 50);
    do {
        if (sum & 1)
            continue;
        sum++;
    } while (sum++ < 90);
    printf("%d\n", sum);
    for (i = 0; i < 6; i++) {
        switch (i) {
        case 1: continue;
        case 4: goto out;
        default: break;
        }
        printf("%d ", i);
    }
out:
    printf("%d\n", i);
    if (i)
        if (!i)
            printf("inner\n");
        else
            printf("else of the inner if\n");
    if (1)
        SWAP(i, j);
    else
        printf("never\n");
    printf("%d %d\n", i, j);
    for (unsigned char c = 250; c; c++)
        sum -= c;
    printf("%d\n", sum);
    return 0;
}
