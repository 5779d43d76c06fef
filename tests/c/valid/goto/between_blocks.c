/* Jumps into and out of blocks; variables declared there exist, but are uninitialised. */
#include <stdio.h>

static int search(int wanted)
{
    int i, j, grid[3][3] = { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } };

    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            if (grid[i][j] == wanted)
                goto found;
    return -1;
found:
    return i * 10 + j;
}

static int into(int n)
{
    int r = 0;
    if (n > 5)
        goto middle;
    while (n-- > 0) {
        int local;
        local = 3;
        r += local;
middle:
        local = 7;
        r += local + n;
    }
    return r;
}

static int cleanup(int fails_at)
{
    int got = 0;
    if (fails_at == 1)
        goto none;
    got |= 1;
    if (fails_at == 2)
        goto first;
    got |= 2;
    if (fails_at == 3)
        goto both;
    return got | 8;
both:
    got ^= 2;
first:
    got ^= 1;
none:
    return got | 16;
}

int main(void)
{
    printf("%d %d\n", search(6), search(10));
    printf("%d %d %d\n", into(2), into(6), into(0));
    for (int i = 1; i <= 4; i++)
        printf("%d ", cleanup(i));
    printf("\n");
    goto end;
    { unused: printf("never\n"); goto unused; }
end:
    return 0;
}
