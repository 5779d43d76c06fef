/* Variadic functions: ints, doubles, long longs, pointers, promoted small types. */
#include <stdio.h>
#include <stdarg.h>

static int sum(int count, ...)
{
    va_list ap;
    int total = 0;

    va_start(ap, count);
    while (count--)
        total += va_arg(ap, int);
    va_end(ap);
    return total;
}

static double mean(int count, ...)
{
    va_list ap;
    double total = 0;
    int i;

    va_start(ap, count);
    for (i = 0; i < count; i++)
        total += va_arg(ap, double);
    va_end(ap);
    return count ? total / count : 0;
}

static void show(const char *types, ...)
{
    va_list ap;

    va_start(ap, types);
    for (; *types; types++)
        switch (*types) {
        case 'i': printf("%d ", va_arg(ap, int)); break;
        case 'u': printf("%u ", va_arg(ap, unsigned)); break;
        case 'l': printf("%lld ", va_arg(ap, long long)); break;
        case 'd': printf("%g ", va_arg(ap, double)); break;
        case 's': printf("%s ", va_arg(ap, char *)); break;
        case 'p': printf("%d ", *va_arg(ap, int *)); break;
        case 'f': printf("%d ", va_arg(ap, int (*)(int, ...))(2, 30, 12)); break;
        }
    va_end(ap);
    printf("\n");
}

int main(void)
{
    char c = -5;
    short s = 300;
    unsigned char uc = 250;
    float f = 2.5f;
    int n = 77;

    printf("%d %d\n", sum(3, 1, 2, 3), sum(0));
    printf("%g %g\n", mean(2, 1.0, 2.0), mean(3, f, 2.5, (double) n));
    show("iiu", c, s, uc);
    show("ldl", 1ll << 40, 0.5, -1ll);
    show("dsip", f, "text", 'x', &n);
    show("idilid", 1, 2.5, 3, 4ll, 5, 6.5);
    show("fi", sum, 9);
    show("");
    return 0;
}
