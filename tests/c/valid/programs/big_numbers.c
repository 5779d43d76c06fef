/* Big numbers: factorial of 60, Fibonacci 200, powers, digit sums, division by small. */
#include <stdio.h>
#include <string.h>

#define LIMBS 24
#define BASE 1000000000u

typedef struct { unsigned limb[LIMBS]; int used; } Big;

static Big small(unsigned n)
{
    Big b = { { n }, 1 };
    return b;
}

static void multiply(Big *b, unsigned by)
{
    unsigned long long carry = 0;
    int i;

    for (i = 0; i < b->used; i++) {
        carry += (unsigned long long) b->limb[i] * by;
        b->limb[i] = carry % BASE;
        carry /= BASE;
    }
    if (carry)
        b->limb[b->used++] = carry;
}

static Big add(Big a, Big b)
{
    int i, n = a.used > b.used ? a.used : b.used;
    unsigned carry = 0;

    for (i = 0; i < n; i++) {
        unsigned s = (i < a.used ? a.limb[i] : 0) + (i < b.used ? b.limb[i] : 0) + carry;
        a.limb[i] = s % BASE;
        carry = s / BASE;
    }
    if (carry)
        a.limb[n++] = carry;
    a.used = n;
    return a;
}

static unsigned divide(Big *b, unsigned by)
{
    unsigned long long rest = 0;
    int i;

    for (i = b->used - 1; i >= 0; i--) {
        rest = rest * BASE + b->limb[i];
        b->limb[i] = rest / by;
        rest %= by;
    }
    while (b->used > 1 && b->limb[b->used - 1] == 0)
        b->used--;
    return rest;
}

static char *text(const Big *b, char *to)
{
    int i, n = sprintf(to, "%u", b->limb[b->used - 1]);

    for (i = b->used - 2; i >= 0; i--)
        n += sprintf(to + n, "%09u", b->limb[i]);
    return to;
}

int main(void)
{
    char buffer[256], *p;
    Big f = small(1), a = small(0), b = small(1), t;
    int i, sum = 0;

    for (i = 2; i <= 60; i++)
        multiply(&f, i);
    printf("%s\n", text(&f, buffer));
    for (p = buffer; *p; p++)
        sum += *p - '0';
    printf("%d\n", sum);
    for (i = 0; i < 200; i++) {
        t = add(a, b);
        a = b;
        b = t;
    }
    printf("%s\n", text(&a, buffer));
    for (i = 60; i > 20; i--)
        if (divide(&f, i))
            printf("rest at %d\n", i);
    printf("%s ", text(&f, buffer));
    printf("%u\n", divide(&f, 1000007));
    return 0;
}
