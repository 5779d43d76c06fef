/* Inner braces may be omitted; missing values are zero. */
#include <stdio.h>

struct in { char c; int v[2]; };
struct out { struct in a, b; int tail; };

static struct out full = { { 'a', { 1, 2 } }, { 'b', { 3, 4 } }, 5 };
static struct out flat = { 'a', 1, 2, 'b', 3, 4, 5 };
static struct out partial = { 'x', { 1 }, { 'y' } };
static int m[2][3] = { 1, 2, 3, 4 };
static int n[][2] = { { 1 }, { 2, 3 }, 4, 5, 6 };
static char text[2][4] = { "ab", { 'c', 'd', 'e', 'f' } };
static int scalar = { 7 };
static union { int i; char c; } u[2] = { 65, { 66 } };
static struct { struct { int x; } p; int y; } s[] = { 1, 2, { 3 }, 4, { { 5 } } };

int main(void)
{
    struct in auto_ = { 'q' };
    int zeros[5] = { 0 }, i;
    struct out copy = { full.a, .tail = 9 };
    struct in pair[2] = { auto_, { 'r', 8, 9 } };

    printf("%d %d %d\n", flat.b.v[0] == full.b.v[0], flat.tail, flat.a.c == full.a.c);
    printf("%c %d %d %c %d\n", partial.a.c, partial.a.v[0], partial.a.v[1], partial.b.c, partial.tail);
    for (i = 0; i < 6; i++)
        printf("%d ", m[i / 3][i % 3]);
    printf("\n%d %d %d %d\n", (int) (sizeof n / sizeof *n), n[0][1], n[3][0], n[2][1]);
    printf("%s %.4s %d\n", text[0], text[1], scalar);
    printf("%c %c\n", u[0].c, u[1].c);
    printf("%d %d %d %d\n", (int) (sizeof s / sizeof *s), s[1].p.x, s[1].y, s[2].p.x);
    printf("%c %d %d %d\n", auto_.c, auto_.v[1], zeros[4], zeros[0]);
    printf("%c %d %d\n", copy.a.c, copy.b.v[1], copy.tail);
    printf("%c %d %c %d\n", pair[0].c, pair[0].v[0], pair[1].c, pair[1].v[1]);
    return 0;
}
