/* Functions used before any declaration return int and accept any arguments. */
#include <stdio.h>

int main()
{
    int v[3];

    fill(v, 3, 5);
    printf("%d %d %d\n", v[0], v[1], v[2]);
    printf("%d\n", add(3, 4));
    printf("%d\n", largest('a', 'z', 'm'));
    printf("%d %d\n", strlen("implicit"), abs(-5));
    nothing();
    {
        int inner();
        printf("%d\n", inner(2));
    }
    return add(-1, 1);
}

fill(v, n, start)
    int *v, n, start;
{
    while (n--)
        *v++ = start++;
}

int add(a, b)
int a, b;
{
    return a + b;
}

largest(a, b, c)
    char a, b, c;
{
    return a > b ? a > c ? a : c : b > c ? b : c;
}

int inner(int n) { return n * 50; }
nothing() { printf("nothing\n"); }
