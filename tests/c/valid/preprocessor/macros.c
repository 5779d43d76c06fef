/* Function-like macros: arguments, nesting, stringify, paste, self reference. */
#include <stdio.h>

#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define MAX3(a, b, c) MAX(MAX(a, b), c)
#define SQUARE(x) x * x
#define STR(x) #x
#define XSTR(x) STR(x)
#define CAT(a, b) a##b
#define XCAT(a, b) CAT(a, b)
#define VALUE 42
#define EMPTY
#define CALL(f, ...) f(__VA_ARGS__)
#define LOG(format, ...) printf("log: " format "\n", ##__VA_ARGS__)
#define SWAP(type, a, b) do { type t_ = a; a = b; b = t_; } while (0)
#define FIRST(a, b) a
#define f(x) (x + f)
#define NOARGS() 7

int main(void)
{
    int CAT(var, 1) = 5, XCAT(v, VALUE) = 6, f = 100, a = 1, b = 2;

    printf("%d %d\n", MAX(3, 4), MAX3(1, 9, 5));
    printf("%d %d\n", SQUARE(3 + 1), SQUARE((3 + 1)));
    printf("%s %s %s\n", STR(VALUE), XSTR(VALUE), STR(a + "b\n" 'c'));
    printf("%s\n", STR(  spaced   out  ));
    printf("%d %d\n", var1, v42);
    CALL(printf, "%d %s\n", 3, "three");
    LOG("no arguments");
    LOG("%d and %d", 1, 2);
    SWAP(int, a, b);
    printf("%d %d\n", a, b);
    printf("%d\n", f(1));
    printf("%d\n", FIRST(1, 2) EMPTY + NOARGS());
    printf("%d\n", MAX (1, 2));
    printf("%d\n", MAX
           (5,
            6));
#undef VALUE
#define VALUE 43
    printf("%s\n", XSTR(VALUE));
    printf("%d\n", XCAT(1, XCAT(2, 3)));
    return 0;
}
