/* Member layout of gcc -m32 -malign-double: alignment, padding, nested structs and arrays. */
#include <stddef.h>
#include <stdio.h>

struct a { char c; int i; char d; };
struct b { char c; double d; char e; };
struct c { char c; struct a a; short s; };
struct d { short s[3]; char c[5]; long long q; };
struct e { char c; union { char d; double e; } u; };
struct f { char c[3]; struct { char d; } in; short s; };
struct g { struct b b[2]; char c; };
union u { char c[9]; int i; struct d d; };

#define AT(type, member) (unsigned) offsetof(struct type, member)

int main(void)
{
    printf("%u %u %u\n", (unsigned) sizeof(struct a), AT(a, i), AT(a, d));
    printf("%u %u %u\n", (unsigned) sizeof(struct b), AT(b, d), AT(b, e));
    printf("%u %u %u\n", (unsigned) sizeof(struct c), AT(c, a), AT(c, s));
    printf("%u %u %u\n", (unsigned) sizeof(struct d), AT(d, c), AT(d, q));
    printf("%u %u\n", (unsigned) sizeof(struct e), AT(e, u));
    printf("%u %u %u\n", (unsigned) sizeof(struct f), AT(f, in), AT(f, s));
    printf("%u %u %u\n", (unsigned) sizeof(struct g), AT(g, b[1]), AT(g, c));
    printf("%u %u\n", AT(c, a.d), AT(g, b[1].e));
    printf("%u %u\n", (unsigned) sizeof(union u), (unsigned) _Alignof(union u));
    printf("%u %u %u\n", (unsigned) _Alignof(struct a), (unsigned) _Alignof(struct f),
           (unsigned) _Alignof(double));
    printf("%u\n", (unsigned) sizeof(struct { char a; char b[2]; struct { short c; char d; } e; }));
    return 0;
}
