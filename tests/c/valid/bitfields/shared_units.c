/* A bit-field whose unit covers the members before it leaves them alone, also in initialisers. */
#include <stdio.h>

static int cells[4] = { 5, 6, 7, 8 };
struct s { int *p; unsigned long long b : 18; };
struct t { char c; int n : 20; };
union u { int : 3; int *p; char c; };

static struct s x = { cells + 2, 77 };
static struct s list[2] = { [1] = { .b = 3, .p = cells } };
static struct t y = { 'y', -5 };
static union u z = { cells + 3 };

static int at(const int *p) { return p ? *p : -1; }

int main(void)
{
    struct s l = { cells + 1, 9 };
    union u m = { cells };

    printf("%d %d %d %d\n", at(x.p), (int) x.b, at(list[1].p), (int) list[1].b);
    printf("%c %d %d %d\n", y.c, y.n, at(l.p), (int) l.b);
    printf("%d %d\n", at(z.p), at(m.p));
    l.b = -1;
    y.n++;
    printf("%d %d %c %d\n", at(l.p), (int) l.b, y.c, y.n);
    return 0;
}
