/* `a op= b` computes in the common type, and evaluates the lvalue once. */
#include <stdio.h>

static int calls;
static int *place(int *p) { calls++; return p; }

int main(void)
{
    int i = 10, values[3] = { 1, 2, 3 }, *p = values;
    unsigned char c = 240;
    float f = 1.5f;
    double d = 10;
    long long q = 1;
    unsigned u = 5;

    i *= 1.75;
    c += 10.7;
    f += i;
    d -= f * c;
    q <<= 35;
    q |= u;
    u -= 6ll;
    printf("%d %d %g %g %lld %u\n", i, c, f, d, q, u);
    i = -7;
    i /= 2u;
    printf("%d\n", i);
    i = 100;
    i >>= 2ull;
    i %= 7l;
    i ^= 'a';
    printf("%d\n", i);
    *p++ += 10;
    *p++ *= 10;
    *place(values) -= 1;
    values[*place(values) % 2] += 5;
    printf("%d %d %d %d %d\n", values[0], values[1], values[2], (int) (p - values), calls);
    p -= 2ll;
    p += (unsigned char) 1;
    printf("%d\n", *p);
    f /= 3;
    d = f;
    printf("%a %a\n", f, d * 3);
    i = (c = 255, c += 1);
    printf("%d\n", c);
    return 0;
}
