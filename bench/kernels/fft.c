/* A complex fast Fourier transform in place, forth and back (Cooley and Tukey 1965, radix 2). */
#include <math.h>
#include <stdio.h>

#define POINTS 4096

struct complex { double re, im; };

static struct complex data[POINTS], roots[POINTS / 2];

static void transform(struct complex *v, int n, int inverse)
{
    int i, j, bit, length, k;

    for (i = 1, j = 0; i < n; i++) {
        for (bit = n >> 1; j & bit; bit >>= 1)
            j ^= bit;
        j ^= bit;
        if (i < j) {
            struct complex t = v[i];
            v[i] = v[j];
            v[j] = t;
        }
    }
    for (length = 2; length <= n; length <<= 1) {
        int half = length >> 1, stride = n / length;
        for (i = 0; i < n; i += length)
            for (k = 0; k < half; k++) {
                struct complex w = roots[k * stride], a = v[i + k], b = v[i + k + half], t;
                if (inverse)
                    w.im = -w.im;
                t.re = b.re * w.re - b.im * w.im;
                t.im = b.re * w.im + b.im * w.re;
                v[i + k].re = a.re + t.re;
                v[i + k].im = a.im + t.im;
                v[i + k + half].re = a.re - t.re;
                v[i + k + half].im = a.im - t.im;
            }
    }
}

int main(void)
{
    double sum = 0;
    int i, round;

    for (i = 0; i < POINTS / 2; i++) {
        roots[i].re = cos(2 * 3.14159265358979323846 * i / POINTS);
        roots[i].im = sin(2 * 3.14159265358979323846 * i / POINTS);
    }
    for (i = 0; i < POINTS; i++)
        data[i].re = i % 17 - 8;
    for (round = 0; round < 300; round++) {
        transform(data, POINTS, 0);
        transform(data, POINTS, 1);
        for (i = 0; i < POINTS; i++) {
            data[i].re /= POINTS;
            data[i].im /= POINTS;
        }
    }
    for (i = 0; i < POINTS; i++)
        sum += data[i].re * (i % 5);
    printf("fft %.6f\n", sum);
    return 0;
}
