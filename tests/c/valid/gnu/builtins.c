/* Builtins that query the compiler, hints, and builtin versions of library functions. */
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

struct inner { char c; short v[4]; };
struct outer { int a; struct inner in[3]; union { double d; struct { char x, y; } s; }; };

#define is_constant(x) __builtin_choose_expr(__builtin_constant_p(x), "constant", 0)
#define size_name(x) __builtin_choose_expr(__builtin_types_compatible_p(typeof(x), double), "double", \
    __builtin_choose_expr(__builtin_types_compatible_p(typeof(x), char *), "string", "other"))

static int depth(int n)
{
    if (__builtin_expect(n > 3, 0))
        return n;
    __builtin_prefetch(&n);
    return depth(n + 1);
}

static int total(int count, ...)
{
    __builtin_va_list list, copy;
    int sum = 0;

    __builtin_va_start(list, count);
    __builtin_va_copy(copy, list);
    while (count-- > 0)
        sum += __builtin_va_arg(copy, int);
    __builtin_va_end(copy);
    return sum + __builtin_va_arg(list, int);
}

static int sign(int n)
{
    switch (n < 0 ? -1 : n > 0) {
    case -1: return 'n';
    case 0: return 'z';
    case 1: return 'p';
    }
    __builtin_unreachable();
}

int main(void)
{
    char text[32], other[32];
    char *p = text;
    double d = 1;
    int i = 2, *aligned = __builtin_assume_aligned(&i, 4);
    size_t at = 1;

    printf("%d %d\n", depth(0), total(3, 1, 2, 3));
    printf("%c%c%c\n", sign(-5), sign(0), sign(9));
    printf("%d %d %d\n", __builtin_constant_p(3 + 4 * 2), __builtin_constant_p("x"),
           __builtin_constant_p(i));
    printf("%s %s %s %s\n", is_constant(12), size_name(d), size_name(p), size_name(i));
    printf("%d\n", __builtin_choose_expr(1, i, p) = 5);
    printf("%d %d %d\n", __builtin_types_compatible_p(int, const int),
           __builtin_types_compatible_p(int[5], int[]), __builtin_types_compatible_p(char *, int));
    printf("%d %d %d %d\n", (int)__builtin_offsetof(struct outer, in[2].v[1]),
           (int)offsetof(struct outer, s.y), (int)offsetof(struct outer, in[at].v[at + 1]),
           (int)offsetof(struct outer, d));
    __builtin_strcpy(text, "hello");
    __builtin_memset(other, 'x', 6);
    __builtin_memcpy(other, text, 3);
    other[6] = 0;
    printf("%s %d %d\n", other, (int)__builtin_strlen(text), __builtin_strcmp(text, other) < 0);
    printf("%d %s\n", __builtin_abs(-4), __builtin_strchr(text, 'l'));
    __builtin_sprintf(text, "%d:%s", __builtin_toupper('a'), "b");
    __builtin_puts(text);
    printf("%s %s %d\n", __func__, __FUNCTION__, (int)sizeof __PRETTY_FUNCTION__);
    printf("%d %d\n", *aligned, (int)__builtin_object_size(text + i, 2) == 0);
    p = __builtin_alloca(8);
    __builtin_memcpy(p, "alloca", 7);
    __builtin_printf("%s\n", p);
    if (i == 5)
        __builtin_exit(7);
    __builtin_abort();
}
// exit: 7
