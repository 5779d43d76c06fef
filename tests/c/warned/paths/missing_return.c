/* Functions that end without returning a value. */
#include <stdlib.h>

static int falls(int n)
{
    if (n)
        return 1;
}  // warning: control can reach the end of non-void function 'falls'

static int tests(int n)
{
    while (n)
        n--;
}  // warning: control can reach the end of non-void function 'tests'

static int leaves(int n)
{
    for (;;)
        if (n--)
            break;
}  // warning: control can reach the end of non-void function 'leaves'

static int loops(int n) { for (;;) if (n--) return n; }
static int exits(int n) { if (n) return 1; else exit(n); }
static int either(int n) { if (n) { return 1; } else { return 2; } }
static int does(int n) { do { return n; } while (0); }
static int cases(int n)
{
    switch (n) {
    case 1: return 1;
    case 2: abort();
    default: return 3;
    }
}
static __attribute__((noreturn)) void quit(int n) { exit(n); }
static int quits(int n) { quit(n); }
old(n) { n++; }  // warning: type specifier missing, defaults to 'int'

int main(void)
{
    (void)falls, (void)tests, (void)leaves, (void)loops, (void)exits, (void)either;
    (void)does, (void)cases, (void)quits, (void)old;
}
