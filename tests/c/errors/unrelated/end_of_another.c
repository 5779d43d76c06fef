/* Example: the end of another array ends a loop. */
#include <stdio.h>

static int left[4] = {1, 2, 3, 4};
static int right[4] = {5, 6, 7, 8};

static int sum(const int *from, const int *end)
{
    int total = 0;

    while (from < end) // error: unrelated pointers
        total += *from++;
    return total;
}

int main(void)
{
    printf("%d\n", sum(left, left + 4));
    printf("%d\n", sum(left, right + 4));
    return 0;
}
