/* Macros redefined identically or after #undef; names of function-like macros that are not followed by parentheses are not expanded. */
#include <stdio.h>

#define SAME(a, b) (a + b)
#define SAME(a, b) (a + b)
#define N 1
enum { FIRST = N };
#undef N
#define N 2
enum { SECOND = N };
#undef N
enum { N = 3 };
#undef never_defined

#define putchar(c) wrong(c)
#define min(a, b) ((a) < (b) ? (a) : (b))
static int (min)(int a, int b) { return -(a < b ? a : b); }
#define int_pointer int *
typedef int *real_pointer;
#define EOL "\n"
#define if_zero(x) if (!(x))
#define forever for (;;)

int main(void)
{
    const int_pointer p = 0;
    const real_pointer q = 0;
    int i = 0, object = 5;
    int (*f)(int, int) = min;

    p = &object;
    printf("%d %d %d" EOL, FIRST, SECOND, N);
    printf("%d %d %d\n", SAME(1, 2), min(8, 7), (min)(8, 7));
    printf("%d %d %d\n", f(3, 4), *p, q == 0);
    (putchar)('x');
    (putchar)('\n');
    forever {
        if_zero(i - 3)
            break;
        i++;
    }
    printf("%d\n", i);
    return 0;
}
