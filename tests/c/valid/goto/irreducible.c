/* Irreducible control flow: two labels that jump into each other's loops. */
#include <stdio.h>

static int ping_pong(int n, int side)
{
    int a = 0, b = 0;

    if (side)
        goto right;
left:
    a++;
    if (n-- <= 0)
        goto end;
    if (n % 3 == 0)
        goto left;
right:
    b++;
    if (n-- <= 0)
        goto end;
    if (n % 2)
        goto right;
    goto left;
end:
    return a * 100 + b;
}

static int three(int n)
{
    int trace = 0;

    switch (n % 3) {
    case 0: goto a;
    case 1: goto b;
    default: goto c;
    }
a:
    trace = trace * 4 + 1;
    if (--n < 0)
        return trace;
    if (n & 2)
        goto c;
b:
    trace = trace * 4 + 2;
    if (--n < 0)
        return trace;
    if (n & 1)
        goto a;
c:
    trace = trace * 4 + 3;
    if (--n < 0)
        return trace;
    if (n % 5 == 0)
        goto b;
    goto a;
}

int main(void)
{
    int i;

    for (i = 0; i < 10; i++)
        printf("%d %d ", ping_pong(i, 0), ping_pong(i, 1));
    printf("\n");
    for (i = 0; i < 10; i++)
        printf("%d ", three(i));
    printf("\n");
    return 0;
}
