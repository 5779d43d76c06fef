/* sizeof of types, expressions and objects; alignment. */
#include <stdio.h>
#include <stddef.h>

struct a { char c; short s; int i; };
struct packed_like { char a, b, c; };
struct nested { struct a a[2]; char c; };
typedef int row[7];

#define S(x) ((int) sizeof(x))

int main(void)
{
    int v[10], n = 3, m[2][3], *p = v;
    char text[] = "sized", *q = text;
    struct nested s;
    double d;

    printf("%d %d %d %d %d\n", S(char), S(short), S(int), S(long), S(long long));
    printf("%d %d %d %d\n", S(float), S(double), S(void *), S(int (*)(int)));
    printf("%d %d %d\n", S(struct a), S(struct packed_like), S(struct nested));
    printf("%d %d %d %d %d\n", S(v), S(v[0]), S(p), S(*p), S(&v));
    printf("%d %d %d %d\n", S(m), S(m[0]), S(m[0][0]), S(&m[0]));
    printf("%d %d %d\n", S(text), S(q), S("literal"));
    printf("%d %d %d\n", S(s), S(s.a), S(s.a[0].s));
    printf("%d %d\n", S(row), S(row *));
    printf("%d %d %d\n", S('a'), S(1 + 1ll), S(1.0f * 1));
    printf("%d\n", (int) sizeof n++ + n);
    printf("%d %d\n", (int) sizeof(d) * 2, (int) sizeof d / 2);
    printf("%d\n", S(v) / S(*v));
    printf("%d\n", (int) sizeof(char[3][4]));
    printf("%d %d\n", S(size_t), S(ptrdiff_t));
    printf("%d %d %d\n", (int) _Alignof(int), (int) _Alignof(char), (int) _Alignof(struct a));
    printf("%d\n", sizeof(int) - 5 > 0);
    return 0;
}
