/* Example: the length of a range whose end is in another array. */
#include <stdio.h>

static int left[4] = {1, 2, 3, 4};
static int right[4] = {5, 6, 7, 8};

static int length(const int *from, const int *end)
{
    return end - from; // error: unrelated pointers
}

int main(void)
{
    printf("%d\n", length(left, left + 4));
    printf("%d\n", length(left, right + 4));
    return 0;
}
