/* Subscripts on either side of the brackets, negative subscripts, and subscripts applied to calls, literals and pointers into the middle of an array. */
#include <stdio.h>

static int table[3][4] = { { 1, 2, 3, 4 }, { 5, 6, 7, 8 }, { 9, 10, 11, 12 } };
static int (*rows(void))[4] { return table; }
static int *row(int i) { return table[i]; }

int main(void)
{
    int a[] = { 10, 20, 30, 40, 50 }, *middle = a + 2, i = 1;
    const char *digits = "0123456789abcdef";
    char c = 3;
    long long far = -2;

    printf("%d %d %d\n", middle[-2], middle[0], 2[middle]);
    printf("%d %d %d\n", a[i++], i[a], a[i] + a[i - 1]);
    printf("%d %d %d\n", rows()[1][2], row(2)[3], *row(1));
    printf("%d %d\n", (*(table + 1))[1], *(*(table + 2) + 2));
    printf("%c %c\n", digits[c], "xyz"[c - 1]);
    printf("%d %d\n", middle[far], *(middle - far));
    printf("%d %d\n", (&a[1])[2], *&*&a[4]);
    printf("%d\n", ((int *)table)[5]);
    printf("%d\n", a[a[0] / 10 + a[1] % 3]);
    printf("%d %d\n", (int) (&a[5] - a), (int) (&table[3] - table));
    (i == 2 ? a : middle)[1] = 99;
    printf("%d\n", a[1]);
    for (int *p = &a[4]; p >= a; p--)
        printf("%d ", *p);
    printf("\n");
    return 0;
}
