/* Bessel functions of integer order (POSIX j0 to yn). Up to LARGE the J are computed downwards
   from an order at which they vanish, and normalised by J0 + 2 (J2 + J4 + ...) = 1 (Miller;
   Abramowitz and Stegun 9.12, 9.1.46); Y0 is Neumann's series of them (9.1.89), and Y1 its
   derivative (9.1.28). Above, Hankel's asymptotic expansions are used (9.2.5 to 9.2.10). Errors
   are a few 1e-16 of the amplitude. */
#include <errno.h>
#include <math.h>

#define LARGE 25.0
#define MOST 96             /* the order from which to compute downwards, for x up to LARGE */
#define GAMMA 0.57721566490153286061

/* Computes J of orders 0 to MOST for 0 < x <= LARGE. */
static void all_orders(double x, double j[MOST + 2])
{
    double sum = 0;
    int n;

    j[MOST + 1] = 0;
    j[MOST] = 1e-300;
    for (n = MOST; n > 0; n--) {
        j[n - 1] = 2 * n / x * j[n] - j[n + 1];
        if (fabs(j[n - 1]) > 1e250) {
            int k;
            for (k = n - 1; k <= MOST; k++)
                j[k] *= 1e-250;
        }
    }
    for (n = MOST; n > 0; n -= 2)
        sum += 2 * j[n];
    sum += j[0];
    for (n = 0; n <= MOST; n++)
        j[n] /= sum;
}

/* Computes J and Y of order 0 or 1 for x > LARGE. */
static void asymptotic(int n, double x, double *first, double *second)
{
    double p = 1, q = 0, term = 1, scale = sqrt(2 / (M_PI * x)) * M_SQRT1_2;
    double s = sin(x), c = cos(x), cosine, sine;
    int k;

    for (k = 1; k < 40; k++) {
        double next = term * (4.0 * n * n - (2.0 * k - 1) * (2.0 * k - 1)) / (8.0 * k * x);
        if (fabs(next) > fabs(term) || fabs(next) < 1e-18)
            break;
        term = next;
        switch (k % 4) {
        case 1: q += term; break;
        case 2: p -= term; break;
        case 3: q -= term; break;
        default: p += term;
        }
    }
    cosine = n == 0 ? c + s : s - c;
    sine = n == 0 ? s - c : -s - c;
    *first = scale * (p * cosine - q * sine);
    *second = scale * (p * sine + q * cosine);
}

static double j_of(int n, double x)
{
    double j[MOST + 2], first, second;

    if (x == 0)
        return n == 0;
    if (x > LARGE) {
        asymptotic(n, x, &first, &second);
        return first;
    }
    all_orders(x, j);
    return j[n];
}

static double y_small(int n, double x)
{
    double j[MOST + 2], sum = 0, logarithm = log(x / 2) + GAMMA;
    int k, sign = -1;

    all_orders(x, j);
    for (k = 1; 2 * k + 1 <= MOST; k++, sign = -sign)
        sum += sign * (n == 0 ? -2 * j[2 * k] : j[2 * k - 1] - j[2 * k + 1]) / k;
    return M_2_PI * (n == 0 ? logarithm * j[0] + sum : logarithm * j[1] - j[0] / x + sum);
}

static double y_of(int n, double x)
{
    double first, second;

    if (x <= 0) {
        errno = x == 0 ? ERANGE : EDOM;
        return x == 0 ? -HUGE_VAL : NAN;
    }
    if (x <= LARGE)
        return y_small(n, x);
    asymptotic(n, x, &first, &second);
    return second;
}

/* The functions of orders 0 and 1 for all x. */
static double first_kind(int n, double x)
{
    if (isnan(x))
        return x;
    if (isinf(x))
        return 0;
    return n == 1 && x < 0 ? -j_of(1, -x) : j_of(n, fabs(x));
}

static double second_kind(int n, double x)
{
    return isnan(x) ? x : x == HUGE_VAL ? 0 : y_of(n, x);
}

double j0(double x)
{
    return first_kind(0, x);
}

double j1(double x)
{
    return first_kind(1, x);
}

double y0(double x)
{
    return second_kind(0, x);
}

double y1(double x)
{
    return second_kind(1, x);
}

/* J of an order n > x, downwards from an order far above. */
static double downwards(int n, double x)
{
    double above = 0, at = 1e-300, below, wanted = 0, sum = 0;
    int k = 2 * ((n + (int)sqrt(60.0 * n) + 20) / 2);

    for (; k > 0; k--) {
        below = 2 * k / x * at - above;
        above = at;
        at = below;
        if (k - 1 == n)
            wanted = at;
        if (k % 2 == 1 && k > 1)
            sum += 2 * at;
        if (fabs(at) > 1e250) {
            above *= 1e-250;
            at *= 1e-250;
            wanted *= 1e-250;
            sum *= 1e-250;
        }
    }
    return wanted / (sum + at);
}

double jn(int n, double x)
{
    double before, at, next;
    int sign = 1, k;

    if (isnan(x))
        return x;
    if (n < 0) {
        n = -n;
        x = -x;
    }
    if (x < 0) {
        x = -x;
        sign = n % 2 ? -1 : 1;
    }
    if (n <= 1)
        return sign * first_kind(n, x);
    if (x == 0 || isinf(x))
        return 0;
    if (n > x)
        return sign * downwards(n, x);
    before = first_kind(0, x);
    at = first_kind(1, x);
    for (k = 1; k < n; k++) {
        next = 2 * k / x * at - before;
        before = at;
        at = next;
    }
    return sign * at;
}

double yn(int n, double x)
{
    double before, at, next;
    int sign = 1, k;

    if (n < 0) {
        n = -n;
        sign = n % 2 ? -1 : 1;
    }
    if (isnan(x) || x <= 0 || n == 0)
        return second_kind(0, x);
    if (x == HUGE_VAL)
        return 0;
    before = second_kind(0, x);
    at = second_kind(1, x);
    for (k = 1; k < n && at != -HUGE_VAL; k++) {
        next = 2 * k / x * at - before;
        before = at;
        at = next;
    }
    return sign * at;
}
