/* Layout: offsetof, sizeof and alignment of members by natural alignment. */
#include <stdio.h>
#include <stddef.h>

struct a { char c; int i; char d; };
struct b { char c[3]; short s; char e; };
struct c { struct a first; struct b second; char *p; };
union u { char c; short s[5]; int i; };
struct d { char c; union u u; char tail; };
struct e { unsigned char r, g, b; };

#define SHOW(type, member) printf("%s.%s %d\n", #type, #member, (int) offsetof(type, member))

int main(void)
{
    struct e pixels[4];

    SHOW(struct a, i);
    SHOW(struct a, d);
    SHOW(struct b, s);
    SHOW(struct b, e);
    SHOW(struct c, second);
    SHOW(struct c, second.s);
    SHOW(struct c, p);
    SHOW(struct d, u);
    SHOW(struct d, tail);
    SHOW(struct e, b);
    printf("%d %d %d\n", (int) sizeof(struct a), (int) sizeof(struct b), (int) sizeof(struct c));
    printf("%d %d %d\n", (int) sizeof(union u), (int) sizeof(struct d), (int) sizeof(struct e));
    printf("%d\n", (int) ((char *) &pixels[2].g - (char *) pixels));
    printf("%d\n", (int) sizeof pixels);
    return 0;
}
