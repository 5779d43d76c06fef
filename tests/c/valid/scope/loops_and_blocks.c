/* Names declared in for statements, blocks, switch statements and parameter lists. */
#include <stdio.h>

static int i = 100;
static int twice(int i) { { int i = 7; (void) i; } return 2 * i; }
static int size(int n, int (*a)[3], int m) { (void) n; return (int) sizeof *a + m; }

int main(void)
{
    int sum = 0, a[2][3];

    for (int i = 0; i < 3; i++) {
        int i = 10;
        sum += i;
    }
    for (int i = 0, n = 3; i < n; i++)
        for (int i = 0; i < 2; i++)
            sum++;
    printf("%d %d\n", sum, i);
    if (sum) {
        extern int printf(const char *, ...);
        int sum = 1;
        printf("%d\n", sum);
    }
    while (sum > 30) {
        static int sum_before = 5;
        int again = sum_before--;
        sum -= again;
    }
    printf("%d\n", sum);
    switch (sum % 3) {
        int inside;
    case 0:
        inside = 4;
        printf("%d\n", inside);
        break;
    default:
        inside = 5;
        printf("%d\n", inside);
    }
    for (struct { int n; } s = { 2 }; s.n--;)
        printf("%d ", s.n);
    printf("%d %d\n", twice(i), size(1, a, i));
    return 0;
}
