/* Tentative definitions are merged with each other and with the one that has an initialiser. */
#include <stdio.h>

int shared;
int shared;
extern int shared;
static int own;
int shared = 5;
static int own = 6;
int zero;
double values[4];
extern double values[];
struct point { int x, y; } origin;
struct point origin;
int list[];
int list[3];
char *name;

static int read_own(void) { return own; }

int main(void)
{
    extern int zero;
    extern char *name;

    printf("%d %d %d\n", shared, own, zero);
    printf("%g %d %d\n", values[3], origin.x, (int) sizeof list);
    printf("%d\n", name == 0);
    values[1] = 2.5;
    own++;
    zero = read_own() + shared;
    printf("%d %g\n", zero, values[1]);
    return 0;
}
