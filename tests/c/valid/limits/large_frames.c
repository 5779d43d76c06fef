/* Large local variables, deep calls with large frames, large structs by value. */
#include <stdio.h>
#include <string.h>

struct huge { int v[2000]; };

static struct huge fill(struct huge h, int by)
{
    int i;

    for (i = 0; i < 2000; i++)
        h.v[i] += by * i;
    return h;
}

static int deep(int n)
{
    char space[4000];

    memset(space, n, sizeof space);
    if (n == 0)
        return 0;
    return deep(n - 1) + space[n * 13];
}

int main(void)
{
    int table[20000], i;
    struct huge h = { { 1, 2 } };

    for (i = 0; i < 20000; i += 100)
        table[i] = i;
    h = fill(fill(h, 1), 2);
    printf("%d %d %d\n", h.v[0], h.v[1], h.v[1999]);
    printf("%d %d\n", deep(100), table[19900]);
    return 0;
}
