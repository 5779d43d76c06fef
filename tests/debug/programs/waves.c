/* Complex numbers and nested functions, as the debugger shows them. */
#include <complex.h>
#include <stdio.h>

struct wave {
    double complex value;
    float complex parts[2];
};

static int apply(int (*visit)(int), int count)
{
    return count > 0 ? visit(count) + apply(visit, count - 1) : 0;
}

static int sum(int scale)
{
    int total = 5;
    struct wave wave = { 1 - 2.5 * I, { 1, I } };
    int add(int x)
    {
        wave.value *= I;
        total += x * scale;
        return total;
    }
    return apply(add, 3);
}

int main(void)
{
    printf("%d\n", sum(3));
    return 0;
}
