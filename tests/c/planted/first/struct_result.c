/* A function returns a struct, not all of it set. */
#include <stdio.h>
struct range { int low, high; };
static struct range find(int n)
{
    struct range r;
    r.low = n;
    if (n > PLANT(5, 1))
        r.high = n + 10;
    return r;
}
int main(void)
{
    struct range r = find(3);
    int i, sum = 0;
    for (i = r.low; i < r.high; i++) // error: uninitialised read
        sum += i;
    printf("%d\n", sum);
    return 0;
}
