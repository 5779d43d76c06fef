/* Adds up one element too many. */
#include <stdio.h>

static int sum(const int *from, int count)
{
    int i, total = 0;

    for (i = 0; i <= count; i++)
        total += from[i];
    return total;
}

int main(void)
{
    int marks[3] = { 1, 2, 3 };

    printf("%d\n", sum(marks, 3));
    return 0;
}
