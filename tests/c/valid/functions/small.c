/* Small functions, which are inlined: structs by value, nested calls, narrow types, old habits. */
#include <stdio.h>
#include <string.h>

typedef struct { double x, y, z; } vec;
typedef struct { int low, high; } range;
typedef struct { vec position, speed; float mass; int number; } body;

static vec add(vec a, vec b) { vec r = { a.x + b.x, a.y + b.y, a.z + b.z }; return r; }
static vec sub(vec a, vec b) { vec r; r.x = a.x - b.x; r.y = a.y - b.y; r.z = a.z - b.z; return r; }
static vec scale(vec a, double k) { return (vec){ a.x * k, a.y * k, a.z * k }; }
static double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec zero(void) { vec r = { 0 }; return r; }
static vec same(vec a) { vec b = a, c; c = b; return c; }
static vec between(vec a, vec b, double t) { return add(scale(a, 1 - t), scale(b, t)); }
static range sorted(int a, int b) { range r; if (a < b) { r.low = a; r.high = b; } else { r.low = b; r.high = a; } return r; }
static range swapped(range r) { int t = r.low; r.low = r.high; r.high = t; return r; }
static int width(range r) { return r.high - r.low; }
static void exchange(int *a, int *b) { int t = *a; *a = *b; *b = t; }
static signed char narrow(signed char c) { return c + 1; }
static unsigned short half(unsigned short s) { s >>= 1; return s; }
static unsigned char low_byte(unsigned value) { return value; }
static int old(a, b) int a; char b; { return a * 100 + b; }
static float mixed(float f, double d, long long l, short s) { return f + d + l + s; }
static int kind(int c) { switch (c) { case 'a': return 1; case 'b': case 'c': return 2; default: return 0; } }
static int min(int a, int b) { return a < b ? a : b; }
static int max(int a, int b) { return a > b ? a : b; }
static int clamp(int x, int low, int high) { return max(low, min(x, high)); }
static body moved(body b, double dt) { b.position = add(b.position, scale(b.speed, dt)); b.number++; return b; }
static unsigned seed = 1;
static unsigned next(void) { seed = seed * 1103515245u + 12345u; return seed >> 16 & 0x7fff; }
static int sum_to(int n) { return n <= 0 ? 0 : n + sum_to(n - 1); }
static void ignore(int unused, vec also) { (void)unused; (void)also; }
static int *pick(int *a, int *b, int first) { return first ? a : b; }
static vec pair[2];
static vec *at(int i) { return &pair[i & 1]; }

static void print(const char *name, vec v) { printf("%s %g %g %g\n", name, v.x, v.y, v.z); }

int main(void)
{
    vec a = { 1, 2, 3 }, b = { -4, 5, 0.5 };
    body planet = { { 1, 2, 3 }, { 0.1, 0.2, 0.3 }, 2.5f, 7 };
    range r = sorted(9, 4);
    int i, x = 3, y = 8, total = 0;

    for (i = 0; i < 4; i++) {
        a = add(a, scale(sub(b, a), 0.25));
        b = same(add(b, zero()));
        *at(i) = add(*at(i + 1), scale(a, i));
        planet = moved(planet, 0.5);
        r = swapped(swapped(sorted(r.high + i, width(r))));
        exchange(&x, &y);
        total += clamp((int)(next() % 100), 20, 60) + kind("abcd"[i]) + *pick(&x, &y, i & 1);
        ignore(i, a);
    }
    print("a", a);
    print("b", b);
    print("between", between(a, b, 0.5));
    print("pair", pair[0]);
    print("pair", *at(3));
    print("planet", planet.position);
    printf("%g %d %d %d\n", planet.mass, planet.number, r.low, r.high);
    printf("%d %d %d %g\n", x, y, total, dot(a, b));
    printf("%d %d %d %d\n", narrow(127), half(65535), low_byte(0x1234), old(3, 300 & 127));
    printf("%g %d\n", mixed(1.5f, 2.25, 1LL << 33, -3), sum_to(10));
    printf("%g %d\n", add(a, b).x, sorted(3, 2).high);
    a = scale(a, a.x);
    print("a", a);
    return 0;
}
