/* Default argument promotions for `...`: char and short as int, float as double, arrays as pointers. */
#include <stdarg.h>
#include <stdio.h>

enum colour { RED = 3 };
struct three { char c[3]; };

static void show(const char *kinds, ...)
{
    va_list list;
    va_start(list, kinds);
    for (; *kinds; kinds++)
        switch (*kinds) {
        case 'i': printf("%d ", va_arg(list, int)); break;
        case 'u': printf("%u ", va_arg(list, unsigned)); break;
        case 'q': printf("%lld ", va_arg(list, long long)); break;
        case 'd': printf("%g ", va_arg(list, double)); break;
        case 's': printf("%s ", va_arg(list, char *)); break;
        case 'p': printf("%d ", *va_arg(list, int *)); break;
        case 'f': printf("%d ", va_arg(list, int (*)(int))(5)); break;
        case 't': printf("%.3s ", va_arg(list, struct three).c); break;
        }
    va_end(list);
    printf("\n");
}

static int half(int n) { return n / 2; }

static int total(int count, ...)
{
    va_list list;
    int sum = 0;
    va_start(list, count);
    while (count-- > 0)
        sum += va_arg(list, int);
    va_end(list);
    return sum;
}

int main(void)
{
    signed char c = -1;
    unsigned short h = 65535;
    float f = 0.5f;
    _Bool b = 1;
    int array[] = { 7, 8 };
    char text[] = "text";
    struct { unsigned bits : 4; } s = { 15 };

    show("iiid", c, h, b, f);
    show("iisp", 'x', RED, text, array);
    show("qdiqu", 1ll << 40, 2.0f, s.bits, -1ll, 4000000000u);
    show("fit", half, c + h, (struct three) { "abc" });
    show("");
    printf("%d %d\n", total(0), total(5, 1, c, h, b, 'a'));
    return 0;
}
