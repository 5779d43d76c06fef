/* Attributes in all allowed positions. */
#include <stdio.h>

#define UNUSED __attribute__((unused))
__attribute__((noreturn)) extern void leave(int) __attribute__((cold));
extern int __attribute__((const, pure)) half(int n UNUSED, ...);
int half(int n, ...) { return n / 2; }
static int (*table[2])(int, ...) __attribute__((section(".data"))) = {half, half};
enum { ONE __attribute__((unused)) = 1, TWO } __attribute__((unused));
struct point { int x UNUSED, y; } __attribute__((may_alias)) origin UNUSED = {3, 4};
typedef char *__attribute__((unused)) text;
static inline __attribute__((always_inline)) int twice(int n) { return 2 * n; }
int __attribute__(()) __attribute__((unused)) empty;

int main(int argc UNUSED, char **argv __attribute__((__unused__)))
{
    int __attribute__((unused)) a = 1, *__attribute__((unused)) b = &a;
    text name = "name";
    for (int i __attribute__((unused)) = 0; i < 1; i++)
        a += (int __attribute__((unused)))2.5;
    switch (a) {
    case 3:
        a++;
        __attribute__((fallthrough));
    default:
        a++;
    }
    goto end;
end: UNUSED
    printf("%d %d %d %s %d\n", a, *b, table[1](9), name, twice(ONE + TWO) + origin.y);
    return 0;
}
