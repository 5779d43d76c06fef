/* Calls without a prototype that pass more, or other ints and pointers; values nobody wants. */
#include <stdio.h>
#include <stdarg.h>

static int count;

static note() { count++; }

static int first(int a) { return a; }

static int length(const char *s) { int n = 0; while (*s++) n++; return n; }

static int sum(int n, ...)
{
    va_list ap;
    int s = 0;

    va_start(ap, n);
    while (n-- > 0)
        s += va_arg(ap, int);
    va_end(ap);
    return s;
}

static int maybe(int n)
{
    if (n > 0)
        return n;
}

int main(void)
{
    int (*old)() = (int (*)()) length;
    int (*any)() = (int (*)()) sum;
    void (*handler)(int) = (void (*)(int)) note;

    note();
    note(1, 2.5);
    handler(3);
    printf("%d %d %d\n", first(7), old("four"), count);
    printf("%d %d\n", sum(2, 3, 4, 5, 6), any(3, 1, 2, 3));
    maybe(-1);
    printf("%d\n", maybe(3));
    return 0;
}
