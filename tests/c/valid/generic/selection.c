/* _Generic with qualifiers, arrays, functions and structs; expressions that are not selected are not evaluated. */
#include <stdio.h>

struct point { int x; };
static int calls;
static int touch(void) { return ++calls; }

#define KIND(x) _Generic((x), \
    int *: "int *", const int *: "const int *", void *: "void *", \
    struct point: "struct", int (*)(void): "function", char *: "char *", \
    short: "short", long: "long", unsigned char: "byte", default: "default")
#define CONVERT(x) _Generic((x), float: (double) (x), default: (x))

int main(void)
{
    int v[3] = { 1, 2, 3 };
    const int c = 4;
    struct point p = { 5 };
    unsigned char b = 1;
    short s = 2;

    printf("%s %s %s\n", KIND(v), KIND(&c), KIND((void *) 0));
    printf("%s %s %s\n", KIND(p), KIND(touch), KIND("text"));
    printf("%s %s %s %s\n", KIND(b), KIND(s), KIND(1L), KIND(s + b));
    printf("%d\n", _Generic(touch(), int: 7, default: touch()));
    printf("%d\n", calls);
    printf("%d %d\n", (int) sizeof(CONVERT(1.0f)), (int) sizeof(CONVERT(s)));
    return _Generic(c, int: 0, default: 1);
}
