/* const, volatile and restrict: on objects, pointers, members, parameters, through typedefs. */
#include <stdio.h>

typedef int *pointer;
typedef const int number;
struct pair { const int fixed; volatile int free; };

static int sum(const int *restrict a, int n, const volatile int *bias)
{
    int total = 0;
    while (n-- > 0)
        total += *a++;
    return total + *bias;
}

static unsigned length(const char *s) { const char *const start = s; while (*s) s++; return s - start; }
static int first(int a[const 2]) { return a[0]++; }
static const char *name(void) { return "named"; }
static int old(const register int x) { return x + 1; }

int main(void)
{
    int n = 1, m = 2;
    const pointer fixed = &n;
    const int *reads = &n;
    int *const writes = &m;
    volatile int bias = 100;
    number five = 5;
    struct pair pair = { 6, 7 };
    const struct pair *view = &pair;
    const int table[2][2] = { { 1, 2 }, { 3, 4 } };
    const int (*rows)[2] = table;
    int const volatile *const volatile odd = &bias;

    *fixed = 10;
    reads = &m;
    *writes = 20;
    pair.free++;
    printf("%d %d %d\n", n, *reads, sum(table[0], 4, &bias));
    printf("%u %d %s %d\n", length("hello"), five, name(), old(41));
    printf("%d %d %d\n", view->fixed, view->free, rows[1][1]);
    *(int *) &n = 3;
    printf("%d %d\n", first(&n), n);
    bias = bias + 1;
    printf("%d\n", *odd);
    return 0;
}
