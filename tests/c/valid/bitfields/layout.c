/* Bit-field layout, examined byte by byte: zero widths, storage units of several types, arrays of structs with bit-fields. */
#include <stdio.h>
#include <string.h>

struct a { unsigned x : 3, y : 7, z : 25; };
struct b { char c; unsigned x : 4; short s : 5; char d; };
struct c { unsigned x : 4; unsigned : 0; unsigned y : 4; };
struct d { unsigned char x : 6, y : 6, z : 4; };
struct e { _Bool on : 1; unsigned char level : 7; unsigned short rest; };
struct f { unsigned short x : 9; unsigned char y : 7; int z : 17; };

#define DUMP(type, ...) do { \
        type v; \
        memset(&v, 0, sizeof v); \
        v = (type) { __VA_ARGS__ }; \
        dump(#type, &v, sizeof v); \
    } while (0)

static void dump(const char *name, const void *p, unsigned size)
{
    const unsigned char *bytes = p;
    unsigned i;

    printf("%s %u:", name, size);
    for (i = 0; i < size; i++)
        printf(" %02x", bytes[i]);
    printf("\n");
}

static struct a sa = { 5, 100, 0x1ABCDEF };
static struct b sb = { 'c', 9, -7, 'd' };
static struct c sc = { 3, 12 };
static struct d sd[2] = { { 33, 44, 15 }, { 1, 2, 3 } };
static struct e se = { 1, 99, 0xBEEF };
static struct f sf = { 300, 100, -65536 };

int main(void)
{
    dump("a", &sa, sizeof sa);
    dump("b", &sb, sizeof sb);
    dump("c", &sc, sizeof sc);
    dump("d", sd, sizeof sd);
    dump("e", &se, sizeof se);
    dump("f", &sf, sizeof sf);
    DUMP(struct d, 1, 62, 7);
    DUMP(struct e, 0, 127, 1);
    sa.y = ~sa.y;
    sd[1].z -= 5;
    sf.z >>= 3;
    se.on = se.level;
    printf("%d %d %d %d %d\n", sa.y, sd[1].z, sf.z, se.on, sb.s);
    return 0;
}
