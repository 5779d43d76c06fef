/* Variable arguments of types that are read as others which are alike, as C allows it. */
#include <stdarg.h>
#include <stdio.h>
#include <stdint.h>

enum side { LEFT, RIGHT = 7 };
struct pair { short a; char b; };

static int total(const char *kinds, ...)
{
    va_list list, again;
    int sum = 0;

    va_start(list, kinds);
    va_copy(again, list);
    for (; *kinds; kinds++)
        switch (*kinds) {
        case 'i': sum += va_arg(list, int); break;
        case 'u': sum += va_arg(list, unsigned); break;
        case 'l': sum += va_arg(list, unsigned long); break;
        case 'L': sum += (int)va_arg(list, uint64_t); break;
        case 'd': sum += (int)va_arg(list, double); break;
        case 'p': sum += va_arg(list, char *) != NULL; break;
        case 'v': sum += *(char *)va_arg(list, void *); break;
        case 's': sum += va_arg(list, struct pair).b; break;
        }
    sum += 100 * va_arg(again, int);
    va_end(again);
    va_end(list);
    return sum;
}

int main(void)
{
    char c = 3;
    float f = 2.5f;
    struct pair pair = {1, 5};
    const char *text = "x";
    int none = 0;

    printf("%d\n", total("iiiii", 1u, c, RIGHT, (short)4, 5L));
    printf("%d\n", total("uul", 1, 2, 3));
    printf("%d\n", total("iLdds", 1, 4ll, f, 1.0, pair));
    printf("%d\n", total("ipppv", 1, text, 0, none, &c));
    printf("%x %u %ld %c %s\n", -1, 2, 3, 'c', text);
    printf("%d\n", (unsigned)(uintptr_t)text == 0);
    return 0;
}
