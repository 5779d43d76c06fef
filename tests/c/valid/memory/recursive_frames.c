/* Frames come and go at the same places with other variables; none sees what was there. */
#include <stdio.h>
#include <string.h>

static int digits(int n, char *to)
{
    char own[12];
    int length = 0, i;

    do
        own[length++] = '0' + n % 10;
    while ((n /= 10) > 0);
    for (i = 0; i < length; i++)
        to[i] = own[length - 1 - i];
    to[length] = 0;
    return length;
}

static int depth(int n, int *deepest)
{
    int here[4] = { n };
    char name[20];

    digits(n, name);
    if (n == 0)
        return strlen(name);
    if (n > *deepest)
        *deepest = n;
    return here[0] % 3 + depth(n - 1, deepest) + (int) strlen(name);
}

int main(void)
{
    int deepest = 0, i, sum = 0;

    for (i = 1; i < 40; i++)
        sum += depth(i, &deepest);
    printf("%d %d\n", sum, deepest);
    return 0;
}
