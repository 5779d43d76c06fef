/* The functions of <complex.h>. */
#include <stdio.h>
#include <complex.h>
#include <math.h>
typedef double complex dc;

int main(void) {
    dc (*f[])(dc) = { cacos, casin, catan, ccos, csin, ctan, cacosh, casinh, catanh, ccosh,
        csinh, ctanh, cexp, clog, csqrt, conj, cproj };
    double x[] = { -3, -0.0, 0.25, 30 };

    for (unsigned i = 0; i < 16 * sizeof f / sizeof *f; i++) {
        int j = i / 4 % 4, k = i % 4;
        dc z = f[i / 16](CMPLX(x[j], x[k]));
        printf("%u %d %d %.12e %.12e\n", i, j, k, creal(z) + 0.0, cimag(z) + 0.0);
    }
    return 0;
}
