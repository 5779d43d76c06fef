/* _Generic chooses by the type of its operand; _Static_assert and _Alignof. */
#include <stdio.h>

#define NAME(x) _Generic((x), int: "int", unsigned: "unsigned", double: "double", float: "float", \
    char *: "text", const char *: "constant text", long long: "long long", default: "other")
#define ABS(x) _Generic((x), double: abs_double, default: abs_int)(x)

_Static_assert(sizeof(int) == 4, "ILP32");

static int abs_int(int n) { return n < 0 ? -n : n; }
static double abs_double(double d) { return d < 0 ? -d : d; }

int main(void)
{
    char c = 'x', *s = "s";
    const char *k = "k";
    float f = 1;

    printf("%s %s %s %s\n", NAME(1), NAME(1u), NAME(1.0), NAME(f));
    printf("%s %s %s %s\n", NAME(s), NAME(k), NAME(c), NAME(c + 0));
    printf("%s %s\n", NAME(1ll), NAME(&c));
    printf("%d %g\n", ABS(-3), ABS(-2.5));
    _Static_assert(1, "inside");
    return 0;
}
