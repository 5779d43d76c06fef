/* A value converted to _Bool is 0 or 1 (C17 6.3.1.2). */
#include <stdio.h>
#include <stdbool.h>

static bool is_odd(int n)
{
    return n & 1;
}

static _Bool any(unsigned bits)
{
    return bits & 0xFF00;
}

int main(void)
{
    bool b = 256;
    _Bool c = 0.5, d = 0.0;
    int x = 0;
    bool p = &x;
    bool flags[4] = { 3, 0, -1 };
    struct { bool on; int n; bool off; } s = { 42, 7, 0 };

    printf("%d %d %d %d\n", b, c, d, p);
    printf("%d %d %d %d\n", flags[0], flags[1], flags[2], flags[3]);
    printf("%d %d\n", s.on, s.off);
    printf("%d %d\n", is_odd(7), is_odd(-4));
    printf("%d %d\n", any(0x100), any(0xFF));
    printf("%u\n", (unsigned) sizeof(bool));
    b = false;
    b |= 8;
    printf("%d\n", b);
    b += 5;
    printf("%d\n", b);
    b -= 1;
    printf("%d\n", b);
    printf("%d %d\n", true + true, !b);
    b = 2 > 1;
    b ^= 1;
    printf("%d %d\n", b, (bool) 1e-300);
    return 0;
}
