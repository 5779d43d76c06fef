/* goto into the middle of loops and blocks. */
#include <stdio.h>

static int enter_while(int start)
{
    int n = 0;

    goto middle;
    while (start < 10) {
        n += 100;
middle:
        n += start;
        start += 3;
    }
    return n;
}

static int enter_for(int skip)
{
    int i = 5, sum = 0;

    if (skip)
        goto body;
    for (i = 0; i < 8; i++) {
        sum += 10;
body:
        sum += i;
        if (sum > 60)
            goto out;
    }
    return sum;
out:
    return -sum;
}

static int enter_do(int n)
{
    int count = 0;

    if (n % 2)
        goto odd;
    do {
        count += 1;
odd:
        count += 10;
    } while (n-- > 0);
    return count;
}

static int enter_if(int n)
{
    if (n == 3)
        goto inside;
    if (n > 5) {
        n = 100;
inside:
        n++;
    } else {
        n = -1;
    }
    return n;
}

int main(void)
{
    printf("%d %d %d\n", enter_while(0), enter_while(9), enter_while(50));
    printf("%d %d\n", enter_for(0), enter_for(1));
    printf("%d %d\n", enter_do(2), enter_do(3));
    printf("%d %d %d\n", enter_if(3), enter_if(6), enter_if(1));
    return 0;
}
