/* Every way out of the scope of an array gives its memory back: there is too little otherwise. */
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static jmp_buf env;
static char *first;

/* Tells whether an array lies where the first one lay; they do when nothing is lost. */
static int again(char *array, unsigned size)
{
    memset(array, 1, size);
    if (first == NULL)
        first = array;
    return 1;
}

static int loops(int n)
{
    int i, count = 0;

    for (i = 0; i < 60; i++) {
        char big[n];
        count += again(big, sizeof big);
        if (i % 3 == 0)
            continue;
        char second[sizeof big / 2];
        count += again(second, sizeof second);
        if (i == 50)
            break;
    }
    while (i-- > 0) {
        char big[n];
        if (i == 5)
            return count + again(big, n);
        do {
            char small[i + 1];
            count += again(small, i + 1);
            if (i % 2)
                break;
        } while (0);
    }
    return -1;
}

static int jumps(int n)
{
    int i = 0, sum = 0;

again:
    i++;
    {
        char a[n];
        sum += again(a, n);
    inside:;
        char b[n / 4 + i];
        sum += sizeof b;
        b[0] = i;
        if (i % 5 == 1) {
            i++;
            goto inside;
        }
        if (i < 40)
            goto again;
        switch (i) {
        case 42: {
            char c[n / 2];
            sum += again(c, n / 2);
            goto out;
        }
        default:
            i = 40;
            goto again;
        }
    }
out:
    return sum;
}

static int fall(int n, int depth)
{
    char big[n];

    again(big, n);
    if (depth == 0)
        longjmp(env, 7);
    return fall(n / 2, depth - 1) + big[0];
}

static int expression(int n)
{
    int sum = 0;

    for (int i = 0; i < 40; i++)
        sum += ({ char t[n]; memset(t, i, n); t[n - 1]; });
    for (int i = 0, width[n / 8]; i < 40; i++)
        width[i] = sum += sizeof width > 100;
    return sum;
}

static unsigned stack(int n)
{
    char *p = NULL;
    unsigned total = 0;
    int i;

    for (i = 0; i < n; i++) {
        char *q = alloca(i * 100 + 1);
        memset(q, i, i * 100 + 1);
        if (p != NULL)
            total += *p;
        p = q;
    }
    if (n > 20)
        return total * 2;
    return total;
}

int main(void)
{
    int i, n = 1000000;

    printf("%d\n", loops(n));
    printf("%d\n", jumps(n));
    for (i = 0; i < 20; i++)
        if (setjmp(env) == 0)
            fall(n, 3);
    printf("%d\n", expression(n));
    for (i = 0; i < 30; i++)
        printf("%u ", stack(i));
    printf("\n");
    return 0;
}
