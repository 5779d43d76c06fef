/* Variables that no path assigns before they are read. */
#include <stdio.h>

static int chosen(int n)
{
    int x, y, z;
    if (n > 1)
        x = 1;
    else if (n < 0)
        return x;  // warning: variable 'x' is uninitialized when used here
//             ^
    if (n)
        y = 2;
    for (z = 0; z < n; z++)
        x = n;
    return n ? y + x : 0;
}

static int summed(const int *values, int n)
{
    int i, sum, last, first = 1, previous;
    for (i = 0; i < n; i++) {
        sum += values[i];  // warning: variable 'sum' is uninitialized when used here
//      ^
        if (!first && values[i] < previous)
            break;
        first = 0;
        previous = last = values[i];
    }
    return sum + last;
}

static int read_into(int *p) { return *p = 4; }

int main(void)
{
    int a, b, c = c, d, e[2];
    read_into(&a);
    switch (a) {
    case 4:
        d = 1;
        break;
    case 5:
        return d;  // warning: variable 'd' is uninitialized when used here
    }
    e[0] = b;  // warning: declared at
    printf("%d %d %d\n", chosen(2), summed(e, 0), c + d);
    return 0;
}
