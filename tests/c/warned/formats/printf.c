/* printf formats that do not match their arguments, or for which arguments are missing. */
#include <stdio.h>

extern void complain(int level, const char *form, ...) __attribute__((format(printf, 2, 3)));
void complain(int level, const char *form, ...) { (void)level, (void)form; }

int main(void)
{
    double d = 1.5;
    int i = 2;
    long l = 3;
    long long ll = 4;
    char *s = "text";
    unsigned char c = 'c';

    printf("%d\n", d);  // warning: '%d' specifies type 'int' but the argument has type 'double'
//          ^
    printf("%d and %f\n", i, i);  // warning: '%f' specifies type 'double' but the argument has type 'int'
//                 ^
    printf("%s\n", i);  // warning: '%s' specifies type 'char *' but the argument has type 'int'
    printf("%d\n", s);  // warning: use '%s'
    printf("%d %d\n", i);  // warning: '%d' has no argument: the format takes 2, but gets 1
//             ^
    printf("%d\n", i, l);  // warning: the format takes 1 argument, but gets 2
//                    ^
    printf("\t%d" " %y\n", i, i);  // warning: invalid conversion specifier '%y'
//                  ^
    printf("100%\n");  // warning: incomplete format specifier '%'
    printf("%d %lld\n", ll, ll);  // warning: '%d' specifies type 'int' but the argument has type 'long long'
    fprintf(stderr, "%*d\n", d, i);  // warning: '* in %*d' specifies type 'int'
    complain(1, "%d%%", d);  // warning: '%d' specifies type 'int' but the argument has type 'double'
    printf("%d %ld %u %x %c %hhu %5.2f %-10s %p %i %lu %.*s %zu %%\n", c, l, i, i, c, c, d, s,
           (void *)s, i, l, i, s, sizeof i);
    printf("%d %ld %s %Lf %lld %e\n", l, i, &c, 1.0L, ll, 1.0f);
    return 0;
}
