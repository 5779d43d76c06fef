/* _Generic chooses by the type of a value: without qualifiers,
    arrays and functions as pointers. */
#include <stdio.h>
#define T(x) _Generic((x), char: "char", signed char: "schar", unsigned char: "uchar", \
    short: "short", int: "int", unsigned: "uint", long: "long", unsigned long: "ulong", \
    long long: "llong", float: "float", double: "double", long double: "ldouble", \
    char *: "char*", const char *: "cchar*", int *: "int*", const int *: "cint*", \
    int (*)[3]: "arr*", int (*)(int): "fn*", void *: "void*", struct s: "struct", \
    default: "other")
struct s {
    int a;
};
enum e {
    A, B
};
static int f(int x){
    return x;
}
int main(void){
    const int ci = 1;
    char c = 1;
    short sh=1;
    int arr[3];
    struct s s;
    const struct s cs = {1};
    enum e e = A;
    unsigned bf;
    struct {
        unsigned b:3;
        int sb:5;
        unsigned long long w:40;
    } q;
    volatile float vf = 1;
    const char *str = "x";
    int *const cp = arr;
    printf("%s %s %s %s %s %s\n", T(ci), T(c), T(+c), T(sh), T(sh+c), T('a'));
    printf("%s %s %s %s %s\n", T(arr), T(&arr), T(f), T(&f), T("lit"));
    printf("%s %s %s %s %s %s\n", T(s), T(cs), T(A), T(vf), T(str), T(cp));
    printf("%s %s %s %s %s %s\n", T(1L), T(1LL), T(1.0f), T(1.0L), T((void*)0), T(sizeof 1));
    printf("%s %s %s\n", T(1 ? c : sh), T(&ci), T((const int)1));
    printf("%s %s\n", T(c++), T((c)));
    printf("%d\n", _Generic(1, default: 2, long: 3) + _Generic((char)1, char: 10, int: 20));
    return 0;
}

