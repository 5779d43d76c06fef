/* Quotients, products and conversions of complex constants initialise static objects. */
#include <complex.h>
#include <stdio.h>

static double complex quotient = (1.0 + 2.0 * I) / (3.0 - 4.0 * I);
static double complex rounded_once[] = {1 / (0.1 + 0.7 * I), (0.3 + 0.1 * I) / (0.2 + 0.9 * I)};
static double complex product = (1.1 + 2.3i) * (3.7 - 4.9i);
static double complex large = (1e300 + 1e300i) / (1e300 - 2e299i);
static double complex small = (1e-320 + 1e-310i) / (1e-300 - 2e-299i);
static double complex too_large = (1e300 + 1e300i) * (1e300 - 1e300i);
static double complex by_zero = (1.0 + 1.0i) / (0.0 + 0.0i);
static double complex signs[] = {(0.0 + 1.0i) * (0.0 - 1.0i), (-1.0 + 1.0i) / (2.0 - 2.0i)};
static float complex single = (1.0f + 2.0f * I) / (3.0f - 7.0f * I);
static _Complex int whole[] = {(7 + 5i) / (2 - 1i), (-7 + 5i) / (2 + 3i), (7 + 5i) * (2 - 1i)};
static _Complex unsigned unsigned_parts = (200u + 100ui) / (3u + 2ui);
static _Complex long long wide = (200000000000ll + 100lli) / (3ll + 2lli);
static _Complex char narrow = (_Complex char) (-7 + 5i) / (_Complex char) (2 + 3i);
static _Complex int cast = (_Complex int) ((7.5 + 5.0i) / (2 - 1i));
static struct { int part; double real, imaginary; } parts = {
    (int) ((7.5 + 5.0i) / (2 - 1i)), __real__ ((1.1 + 2.3i) / (3.7 - 4.9i)), __imag__ (1i / 2.0),
};

#define SHOW(z) printf(#z " %a %a\n", (double) __real__(z), (double) __imag__(z))

int main(void)
{
    SHOW(quotient), SHOW(rounded_once[0]), SHOW(rounded_once[1]), SHOW(product), SHOW(large);
    SHOW(small), SHOW(too_large), SHOW(by_zero), SHOW(signs[0]), SHOW(signs[1]), SHOW(single);
    SHOW(whole[0]), SHOW(whole[1]), SHOW(whole[2]), SHOW(unsigned_parts), SHOW(wide);
    SHOW(narrow), SHOW(cast);
    printf("%d %a %a\n", parts.part, parts.real, parts.imaginary);
    return 0;
}
