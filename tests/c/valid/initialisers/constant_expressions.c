/* Initialisers of static objects: arithmetic, addresses, sizeof, casts. */
#include <stdio.h>
#include <stddef.h>

enum { BASE = 10 };
#define LIMIT (BASE * 2 + 1)

struct s { int a; int b[4]; };
static struct s object = { 1, { 2, 3, 4, 5 } };
static int number = -(3 + 4) * 2 - LIMIT % 4;
static unsigned mask = ~0u << 4 & 0xFFF;
static double ratio = 1 / 3.0 + 2, whole = 7 / 2;
static float small = 1e-3;
static int cast = (int) 3.99 + (char) 300;
static long long big = 1ll << 40 | 5;
static int truth = (3 > 2) && !0 || 1 / 1, choice = sizeof(int) == 4 ? BASE : -1;
static int *into = &object.b[2], *before = object.b + 3 - 2, *whole_start = (int *) &object;
static int **indirect = &into;
static const char *word = &"scouting"[5];
static int offset = offsetof(struct s, b[1]);
static int (*function)(const char *, ...) = printf;
static void *self = &self;
static char letter = 'a' + 1, wrapped = 200 + 100;
static unsigned char code = -1;
static int size = sizeof object / sizeof object.b[0];
static double minus = -0.5 * 2;
static int from_double = 2.5 * 2;

int main(void)
{
    function("%d %u %g %g %g\n", number, mask, ratio, whole, small);
    printf("%d %lld %d %d\n", cast, big, truth, choice);
    printf("%d %d %d %d\n", *into, *before, *whole_start, **indirect);
    printf("%s %d %d\n", word, offset, self == (void *) &self);
    printf("%c %d %d %d %g %d\n", letter, wrapped, code, size, minus, from_double);
    return 0;
}
