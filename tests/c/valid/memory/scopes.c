/* Blocks that are left and entered in every way keep their variables as long as they should. */
#include <stdio.h>

static int *kept;

static int touch(int *p) { return ++*p; }

static int jump_in(int n)
{
    int *p, turns = 0;

    if (n > 2)
        goto inside;
    {
        int inner;
inside:
        inner = n;
        p = &inner;
        touch(p);
        if (++turns < 3)
            goto inside;
        return *p + turns;
    }
}

static int cases(int n)
{
    int sum = 0;

    switch (n) {
        int shared;
    case 1:
        shared = 5;
        sum += touch(&shared);
        /* falls through */
    case 2:
        shared = 7;
        sum += touch(&shared);
    }
    return sum;
}

static int loops(int n)
{
    int i, sum = 0;

    for (i = 0; i < n; i++) {
        int a[4] = { i, i + 1 }, *p = a;
        if (i % 3 == 1)
            continue;
        {
            int b = p[1], *q = &b;
            sum += touch(q);
            if (i == 7)
                break;
        }
        sum += touch(p + 2);
    }
    while (n-- > 0) {
        struct { int x, y; } s = { n, 1 }, *p = &s;
        do {
            int z = p->x;
            kept = &z;
            p->y += *kept + 1;
        } while (p->y < 5);
        sum += p->y;
    }
    return sum;
}

static int expression(int n)
{
    return ({ int a[2] = { n, n + 1 }; touch(a + 1); a[1]; }) + 1;
}

static int again(int n)
{
    int sum = 0;
back:
    {
        int here = n, *p = &here;
        sum += touch(p);
        if (n-- > 0)
            goto back;
    }
    return sum;
}

int main(void)
{
    printf("%d %d\n", jump_in(1), jump_in(5));
    printf("%d %d %d\n", cases(1), cases(2), cases(3));
    printf("%d %d %d\n", loops(10), expression(4), again(4));
    return 0;
}
