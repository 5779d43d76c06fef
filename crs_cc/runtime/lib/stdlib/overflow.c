/* 64-bit arithmetic that detects overflow; the compiler generates the calls. */

struct number {
    unsigned long long magnitude;
    int is_negative, is_too_large;      /* too large for the magnitude */
};

static struct number number(unsigned long long bits, int is_signed)
{
    struct number made = {bits, 0, 0};

    if (is_signed && (long long)bits < 0) {
        made.magnitude = -bits;
        made.is_negative = 1;
    }
    return made;
}

static struct number sum(struct number a, struct number b)
{
    struct number made = a;

    if (a.is_negative == b.is_negative) {
        made.magnitude += b.magnitude;
        made.is_too_large = made.magnitude < a.magnitude;
    } else if (a.magnitude >= b.magnitude) {
        made.magnitude -= b.magnitude;
    } else {
        made.magnitude = b.magnitude - a.magnitude;
        made.is_negative = b.is_negative;
    }
    return made;
}

static struct number product(struct number a, struct number b)
{
    struct number made = {a.magnitude * b.magnitude, a.is_negative != b.is_negative, 0};

    made.is_too_large = a.magnitude != 0 && made.magnitude / a.magnitude != b.magnitude;
    return made;
}

/* Calculates a op b and stores the low bits; returns whether a number of so many bits is too small.
   op is '+', '-' or '*'. */
int __crs_exact(int op, unsigned long long a, int a_signed, unsigned long long b, int b_signed,
                int bits, int is_signed, unsigned long long *result)
{
    struct number left = number(a, a_signed), right = number(b, b_signed), exact;
    unsigned long long most = ~0ull >> (64 - bits);

    if (op == '*')
        exact = product(left, right);
    else {
        right.is_negative ^= op == '-';
        exact = sum(left, right);
    }
    *result = exact.is_negative ? -exact.magnitude : exact.magnitude;
    if (exact.is_too_large)
        return 1;
    if (is_signed)
        most = (most >> 1) + exact.is_negative;
    else if (exact.is_negative)
        most = 0;
    return exact.magnitude > most;
}
