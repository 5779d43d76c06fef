/* goto forward, backward, out of nested loops, to a label at the end of a block. */
#include <stdio.h>

static int find(int m[3][4], int wanted)
{
    int i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            if (m[i][j] == wanted)
                goto found;
    return -1;
found:
    return i * 10 + j;
}

static int cleanup(int fail_at)
{
    int state = 0;

    if (fail_at == 1)
        goto none;
    state += 1;
    if (fail_at == 2)
        goto first;
    state += 10;
    if (fail_at == 3)
        goto second;
    state += 100;
second:
    state -= 10;
first:
    state -= 1;
none:
    return state;
}

int main(void)
{
    int m[3][4] = { { 1, 2, 3, 4 }, { 5, 6, 7, 8 }, { 9, 10, 11, 12 } };
    int n = 0, i = 0;

again:
    n += i;
    if (++i < 10)
        goto again;
    printf("%d\n", n);
    printf("%d %d %d\n", find(m, 7), find(m, 12), find(m, 13));
    printf("%d %d %d %d\n", cleanup(0), cleanup(1), cleanup(2), cleanup(3));
    goto skip;
    printf("never\n");
skip:
    while (1) {
        if (n > 50)
            goto done;
        n++;
        if (n & 1)
            goto next;
        printf("%d ", n);
next:   ;
    }
done:
    printf("%d\n", n);
    {
        goto end;
end:    ;
    }
    return 0;
}
