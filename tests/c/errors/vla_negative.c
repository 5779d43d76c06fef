/* The computed length of an array is negative. */
#include <string.h>

static int sum(int n)
{
    int values[n]; // error: non-positive array length
    memset(values, 0, sizeof values);
    return values[0];
}

int main(void)
{
    return sum(3) + sum(-1);
}
