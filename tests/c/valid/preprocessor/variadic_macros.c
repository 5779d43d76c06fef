/* Variadic macros, counting arguments, recursion by layers, foreach. */
#include <stdio.h>

#define COUNT_(a, b, c, d, e, n, ...) n
#define COUNT(...) COUNT_(__VA_ARGS__, 5, 4, 3, 2, 1, 0)
#define CAT_(a, b) a##b
#define CAT(a, b) CAT_(a, b)
#define EACH1(f, a) f(a)
#define EACH2(f, a, ...) f(a) EACH1(f, __VA_ARGS__)
#define EACH3(f, a, ...) f(a) EACH2(f, __VA_ARGS__)
#define EACH4(f, a, ...) f(a) EACH3(f, __VA_ARGS__)
#define EACH(f, ...) CAT(EACH, COUNT(__VA_ARGS__))(f, __VA_ARGS__)
#define SHOW(x) printf("%s=%d ", #x, x);
#define ERR(...) printf("E: " __VA_ARGS__)
#define STRINGS(...) #__VA_ARGS__
#define NAMED(fmt, args...) printf(fmt, args)
#define BIT(n) (1u << (n))
#define MASK(hi, lo) (BIT((hi) + 1) - BIT(lo))
#define LIST { 1, 2, \
               3 }
#define ID(x) x

int main(void)
{
    int a = 1, b = 2, c = 3, v[] = LIST;

    printf("%d %d %d\n", COUNT(a), COUNT(a, b), COUNT(x, y, z, w));
    EACH(SHOW, a, b, c, v[2])
    printf("\n");
    ERR("%d %d\n", a, b);
    printf("%s|\n", STRINGS(a, (b, c), "d,e"));
    NAMED("%d-%d\n", b, c);
    printf("%x %x\n", MASK(7, 4), MASK(3, 3));
    printf("%d\n", ID(ID(5)) + ID((1, 2)));
    return 0;
}
