/* The bytes of floats and doubles seen through unions and memcpy. */
#include <stdio.h>
#include <string.h>

union view {
    float f;
    unsigned u;
    unsigned char bytes[4];
};

union wide {
    double d;
    unsigned long long u;
    unsigned words[2];
};

static int exponent(double d)
{
    union wide w;

    w.d = d;
    return (int) (w.u >> 52 & 0x7FF) - 1023;
}

static float fast_inverse_root(float x)
{
    union view v;

    v.f = x;
    v.u = 0x5f3759df - (v.u >> 1);
    return v.f * (1.5f - 0.5f * x * v.f * v.f);
}

int main(void)
{
    union view v = { 1.0f };
    union wide w = { -2.5 };
    unsigned raw = 0x40490fdb;
    float pi;

    printf("%08x %02x %02x\n", v.u, v.bytes[3], v.bytes[0]);
    printf("%016llx %08x %08x\n", w.u, w.words[0], w.words[1]);
    memcpy(&pi, &raw, 4);
    printf("%.9g\n", pi);
    printf("%d %d %d\n", exponent(1), exponent(1000), exponent(0.001));
    printf("%.7g\n", fast_inverse_root(4.0f));
    v.u = 0x7f800000;
    printf("%g\n", v.f);
    v.bytes[3] ^= 0x80;
    printf("%g\n", v.f);
    w.u = 0x3ff0000000000001ull;
    printf("%.17g\n", w.d);
    w.u--;
    printf("%.17g\n", w.d);
    return 0;
}
