/* Ranges in cases and designators, obsolete designators. */
#include <stdio.h>

struct cell { int kind, walls[4]; const char *name; };

static int calls;

static int next(void)
{
    return ++calls * 11;
}

static struct cell map[8] = {
    [0 ... 7] = {.kind = 1, .walls = {[1 ... 2] = 5}, .name = "floor"},
    [2 ... 4].walls[0 ... 1] = 9,
    [6] = {kind: 2, name: "door"},
    {.walls = {1, [2 ... 3] = 2}},
};
static const unsigned char class_of[256] = {
    ['a' ... 'z'] = 1, ['A' ... 'Z'] = 2, ['0' ... '9'] = 3, ['_'] = 1,
};
static int open_ended[] = {[2 ... 4] = 7, 8, [0] = 1, [9 ... 10] = 3};
static int old[4] = {[1] 5, [3] 6};

static const char *season(int month)
{
    switch (month) {
    case 3 ... 5:
        return "spring";
    case 6 ... 8:
        return "summer";
    case 9 ... 11:
        return "autumn";
    case 12:
    case 1 ... 2:
        return "winter";
    case -2147483647 - 1 ... 0:
        return "before";
    case 13 ... 2147483647:
        return "after";
    }
    return "never";
}

static int magnitude(unsigned long long n)
{
    int result = 0;

    switch (n) {
    default:
        result += 1000;
    case 0 ... 9:
        result++;
        break;
    case 0x100000000 ... 0xfffffffffff:
        return 32;
    case ~0ull:
        return 64;
    case 10 ... 99:
        result = 2;
    }
    return result;
}

int main(void)
{
    int i, j, local[6] = {[1 ... 4] = next(), next()};
    struct cell row[3] = {[0 ... 1] = map[6], [1] = {.kind = next()}};
    static const int months[] = {1, 2, 3, 5, 6, 11, 12, 13, 0, -7, 1 << 30};

    for (i = 0; i < 8; i++) {
        printf("%d %s", map[i].kind, map[i].name ? map[i].name : "-");
        for (j = 0; j < 4; j++)
            printf(" %d", map[i].walls[j]);
        printf("\n");
    }
    for (i = 0; i < 128; i++)
        printf("%d", class_of[i]);
    printf("\n%d:", (int)(sizeof open_ended / sizeof *open_ended));
    for (i = 0; i < 11; i++)
        printf(" %d", open_ended[i]);
    printf("\n%d %d %d %d\n", old[0], old[1], old[2], old[3]);
    for (i = 0; i < 6; i++)
        printf("%d ", local[i]);
    printf("%d %d %d %s\n", calls, row[0].kind, row[1].kind, row[1].name ? "kept" : "gone");
    for (i = 0; i < 11; i++)
        printf("%s ", season(months[i]));
    printf("\n%d %d %d %d %d %d\n", magnitude(9), magnitude(10), magnitude(100),
           magnitude(1ull << 32), magnitude(-1), magnitude(~0ull - 1));
    return 0;
}
