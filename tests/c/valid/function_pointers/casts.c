/* Function pointers cast and cast back, compared, stored as void * and as integers. */
#include <stdio.h>

typedef void (*generic)(void);

static int add(int a, int b) { return a + b; }
static double scale(double x) { return 3 * x; }
static void hello(void) { printf("hello\n"); }

struct entry { char kind; generic f; };

int main(void)
{
    struct entry table[] = { { 'a', (generic) add }, { 's', (generic) scale }, { 'h', hello } };
    void *raw = (void *) add;
    unsigned long number = (unsigned long) scale;
    int (*none)(int) = 0;
    int i;

    for (i = 0; i < 3; i++)
        switch (table[i].kind) {
        case 'a': printf("%d\n", ((int (*)(int, int)) table[i].f)(2, 3)); break;
        case 's': printf("%g\n", ((double (*)(double)) table[i].f)(1.5)); break;
        default: table[i].f();
        }
    printf("%d\n", ((int (*)(int, int)) raw)(10, 20));
    printf("%g\n", ((double (*)(double)) number)(-1));
    printf("%d %d\n", none == 0, !none);
    if (raw == (void *) add && table[0].f != table[2].f)
        printf("same and different\n");
    none = (int (*)(int)) hello;
    printf("%d\n", (generic) none == hello);
    return 0;
}
