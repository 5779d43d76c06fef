/* Designated initialisers, out of order, nested, overriding (C17 6.7.9). */
#include <stdio.h>

struct point { int x, y, z; };
struct line { struct point from, to; char name[8]; };

static struct point p = { .z = 3, .x = 1 };
static int sparse[10] = { [3] = 30, 40, [8] = 80, [0] = -1 };
static struct line l = { .to = { 4, 5, 6 }, .from.y = 9, .name = "edge" };
static struct line lines[3] = { [1] = { { 1, 2, 3 } }, [2].to.z = 7, [2].name = "last" };
static int over[4] = { 1, 2, 3, [1] = 20, 30, 40 };
static int matrix[3][3] = { [1][1] = 5, [2] = { 7, 8, 9 }, [0][2] = 3 };
static const char *names[] = { [2] = "two", [0] = "zero" };
static struct { int a; struct { int b[3]; char c; } d[2]; } deep = { 1, { { { 2, 3 }, 'x' }, [1].b[2] = 6 } };

int main(void)
{
    struct point q = { .y = p.x + 1 };
    int n = 4, local[6] = { [2] = n, n * 2, [5] = n * n };
    int i;

    printf("%d %d %d  %d %d %d\n", p.x, p.y, p.z, q.x, q.y, q.z);
    for (i = 0; i < 10; i++)
        printf("%d ", sparse[i]);
    printf("\n%d %d %d %d %s\n", l.from.x, l.from.y, l.to.x, l.to.z, l.name);
    printf("%d %d %d %s [%s]\n", lines[1].from.z, lines[2].to.z, lines[0].to.x, lines[2].name,
           lines[1].name);
    printf("%d %d %d %d\n", over[0], over[1], over[2], over[3]);
    for (i = 0; i < 9; i++)
        printf("%d", matrix[i / 3][i % 3]);
    printf("\n%s %d %s %d\n", names[0], names[1] == 0, names[2], (int) (sizeof names / sizeof *names));
    printf("%d %d %d %c %d\n", deep.a, deep.d[0].b[1], deep.d[0].b[2], deep.d[0].c, deep.d[1].b[2]);
    for (i = 0; i < 6; i++)
        printf("%d ", local[i]);
    printf("\n");
    return 0;
}
