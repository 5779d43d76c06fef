/* A union holds one of its members; all begin at the same address. */
#include <stdio.h>
#include <string.h>

union value { int i; unsigned u; unsigned char bytes[4]; short halves[2]; float f; };
union big { char c; double d; int v[5]; };

static union value from_float(float f)
{
    union value v;

    v.f = f;
    return v;
}

static unsigned swap(union value v)
{
    unsigned char t = v.bytes[0];

    v.bytes[0] = v.bytes[3];
    v.bytes[3] = t;
    t = v.bytes[1];
    v.bytes[1] = v.bytes[2];
    v.bytes[2] = t;
    return v.u;
}

int main(void)
{
    union value v = { 0x12345678 }, w;
    union big b = { .d = 1.0 };
    union value *p = &w;

    printf("%02x %02x %04x\n", v.bytes[0], v.bytes[3], v.halves[1]);
    printf("%08x\n", swap(v));
    printf("%08x\n", from_float(-1.5f).u);
    w = v;
    p->halves[0] = -1;
    printf("%08x %08x\n", w.u, v.u);
    printf("%d\n", (int) sizeof(union value));
    printf("%08x %d\n", b.v[1], b.c);
    b.v[4] = 77;
    printf("%g %d\n", b.d, b.v[4]);
    printf("%d\n", (void *) &v.i == (void *) &v.halves[0]);
    memset(&w, 0x40, sizeof w);
    printf("%.6g\n", w.f);
    return 0;
}
