/* Declarators read inside out. */
#include <stdio.h>

typedef int (*compare)(const void *, const void *);
typedef char name_t[8];
typedef int (*getter[3])(void);
typedef struct list list;
struct list { int n; list *next; };

static int one(void) { return 1; }
static int two(void) { return 2; }
static int three(void) { return 3; }
static getter getters = { one, two, three };

static int by_value(const void *a, const void *b) { return *(const int *) a - *(const int *) b; }

static compare choose(int up) { return up ? by_value : 0; }
static int (*pick(int i))(void) { return getters[i]; }
static int (*(*picker)(int))(void) = pick;
static char (*second(name_t *names))[8] { return names + 1; }

int *(*table[2])[3];

int main(void)
{
    int a = 5, b = 9, *v[3] = { &a, &b, &a }, *(*pv)[3] = &v;
    name_t names[2] = { "left", "right" };
    char *(*lines)[2] = &(char *[2]) { "up", "down" };
    list second_ = { 2, 0 }, first = { 1, &second_ };
    const int *const *pp = (const int *const *) v;

    printf("%d %d\n", choose(1)(&a, &b), choose(0) == 0);
    printf("%d %d %d\n", pick(1)(), (*pick(2))(), picker(0)());
    printf("%s\n", *second(names));
    table[1] = pv;
    printf("%d\n", *(*table[1])[1]);
    printf("%s %s\n", (*lines)[0], lines[0][1]);
    printf("%d\n", first.next->n);
    printf("%d %d\n", **pp, *pp[1]);
    printf("%d %d %d\n", (int) sizeof(getter), (int) sizeof(name_t), (int) sizeof *pv);
    return 0;
}
