/* Arrays become pointers in expressions, but not for sizeof and & (C17 6.3.2.1p3). */
#include <stdio.h>

static unsigned size_in_callee(int v[10])
{
    v[0] = 99;
    return sizeof v;
}

static int sum2(int (*rows)[3], int count)
{
    int i, j, sum = 0;

    for (i = 0; i < count; i++)
        for (j = 0; j < 3; j++)
            sum += rows[i][j];
    return sum;
}

int main(void)
{
    int v[10] = { 1, 2, 3 };
    int m[2][3] = { { 1, 2, 3 }, { 4, 5, 6 } };
    int (*whole)[10] = &v;
    int (*row)[3] = m;
    char s[] = "abc";

    printf("%u %u\n", (unsigned) sizeof v, size_in_callee(v));
    printf("%d %d\n", v[0], *v);
    printf("%u %u %u\n", (unsigned) sizeof m, (unsigned) sizeof m[0], (unsigned) sizeof *m[0]);
    printf("%u\n", (unsigned) sizeof s);
    printf("%d %d\n", (*whole)[2], (int) sizeof *whole);
    printf("%d %d\n", (char *) (whole + 1) - (char *) whole, (char *) (v + 1) - (char *) v);
    printf("%d %d ", row[1][2], *(*(m + 1) + 1));
    printf("%d\n", (*++row)[0]);
    printf("%d\n", sum2(m, 2));
    printf("%d\n", sum2(&m[1], 1));
    printf("%d %d\n", (void *) m == (void *) m[0], (void *) &v == (void *) v);
    printf("%d\n", &m[1][0] - &m[0][0]);
    printf("%c %c\n", "literal"[3], *("literal" + 1));
    return 0;
}
