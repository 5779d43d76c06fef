/* Calls without prototypes, with wrong arguments, structs through '...', order of evaluation. */
#include <stdio.h>
#include <stdarg.h>
struct s {
    char c;
    double d;
    short a[3];
};
struct t {
    char x;
};
struct l {
    long long v;
};
int old();
double dd();
int old(a, b, c) char a;
float b;
short c;
{
    return a + (int)(b * 10) + c;
}
int few(a, b, c) int a, b, c;
{
    return a;
}
double dd(x) double x;
{
    return x * 2;
}
static int va(int n, ...) {
    va_list l;
    int r = 0;
    va_start(l, n);
    while (n--) {
        struct s s = va_arg(l, struct s);
        struct t t = va_arg(l, struct t);
        struct l x = va_arg(l, struct l);
        r += s.c + s.d + s.a[2] + t.x + x.v;
    }
    r += va_arg(l, double);
    va_end(l);
    return r;
}
static int k;
static int nx(void){
    return ++k;
}
int (*fp)() = old;
int main(void){
    struct s s = {1, 2.5, {1,2,3}};
    struct t t = {4};
    struct l x = {1LL << 20};
    printf("%d %d\n", old('a', 1.5, 300), few(1));
    printf("%d\n", few(1,2,3,4,5));
    printf("%d\n", va(2, s, t, x, s, t, x, 1.5));
    printf("%d %d %d\n", nx(), nx(), nx());
    int a = nx() * 100 + nx();
    printf("%d %g %d\n", a, dd(3.0), fp('b', 2.5, 1));
    int i = 1;
    printf("%d %d %d\n", i++, i++, i);
    int v[3] = {0};
    i = 0;
    v[i++] = i;
    printf("%d %d %d\n", v[0], v[1], i);
    k = 10;
    a = k + nx();
    printf("%d ", a);
    a = nx() + k;
    printf("%d ", a);
    a = k - nx() * k;
    printf("%d\n", a);
    int arr[4] = {nx(), nx(), nx()};
    printf("%d %d %d\n", arr[0], arr[1], arr[2]);
    i = 5;
    i = i++ + ++i;
    printf("%d\n", i);
    int *p = arr;
    *p++ = *p;
    printf("%d %d\n", arr[0], (int)(p - arr));
    arr[nx() & 3] = nx();
    printf("%d %d %d %d %d\n", arr[0], arr[1], arr[2], arr[3], k);
    k += nx();
    printf("%d\n", k);
    arr[k & 1] += nx();
    printf("%d %d\n", arr[0], arr[1]);
    return undeclared(3, 4.5) ;
}
int undeclared(a, b) int a;
double b;
{
    return a + b;
}
// exit: 7
// gcc options: -fno-wrapv
// When the first k of k - nx() * k is read is open; gcc reads it later with -fwrapv.
