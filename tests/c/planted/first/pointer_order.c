/* A loop runs to the end of another array. */
#include <stdio.h>
static int left[4] = {1, 2, 3, 4}, right[4] = {5, 6, 7, 8};
static int sum(const int *from, const int *last)
{
    int s = 0;
    while (from <= last) // warning: pointers to different objects
        s += *from++;
    return s;
}
int main(void)
{
    printf("%d\n", sum(left, PLANT(right, left) + 2));
    return 0;
}
