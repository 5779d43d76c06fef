/* Values changed and unchanged inside loops, calls in conditions, early returns. */
#include <stdio.h>

static int calls;

static int limit(void)
{
    calls++;
    return 5;
}

static int first_repeat(const int *v, int n)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            if (v[i] == v[j])
                return v[i];
    return -1;
}

static int collatz(unsigned n)
{
    int steps = 0;

    while (n != 1) {
        n = n & 1 ? 3 * n + 1 : n / 2;
        steps++;
    }
    return steps;
}

static int digits(int n)
{
    int sum = 0;

    do
        sum += n % 10;
    while (n /= 10);
    return sum;
}

int main(void)
{
    int v[] = { 3, 1, 4, 1, 5, 9, 2, 6 }, i, best = 0, at = 0;

    for (i = 0; i < limit(); i++)
        ;
    printf("%d %d\n", i, calls);
    printf("%d %d\n", first_repeat(v, 8), first_repeat(v + 2, 6));
    for (i = 1; i < 100; i++) {
        int steps = collatz(i);
        if (steps > best)
            best = steps, at = i;
    }
    printf("%d %d %d\n", at, best, digits(987654321));
    for (i = 0; i < 3; i++) {
        int i = 7;
        i++;
        calls += i;
    }
    printf("%d %d\n", i, calls);
    return 0;
}
