/* A one-dimensional Kalman filter, a moving median and a low pass over noisy readings. */
#include <stdio.h>
#include <math.h>
#include <string.h>

typedef struct { double x, p, q, r; } Kalman;

static unsigned seed = 42;

static double noise(void)
{
    double sum = 0;
    int i;

    for (i = 0; i < 4; i++) {
        seed = seed * 1664525u + 1013904223u;
        sum += (double) (seed >> 8) / (1 << 24) - 0.5;
    }
    return sum;
}

static double update(Kalman *k, double z)
{
    double gain;

    k->p += k->q;
    gain = k->p / (k->p + k->r);
    k->x += gain * (z - k->x);
    k->p *= 1 - gain;
    return k->x;
}

static double median5(const double *v)
{
    double s[5];
    int i, j;

    for (i = 0; i < 5; i++) {
        double t = v[i];
        for (j = i; j > 0 && s[j - 1] > t; j--)
            s[j] = s[j - 1];
        s[j] = t;
    }
    return s[2];
}

int main(void)
{
    Kalman k = { 50, 100, 0.01, 4 };
    double window[5] = { 0 }, low = 50, truth, error[3] = { 0 };
    int t, i;

    for (t = 0; t < 60; t++) {
        double z, estimates[3];
        truth = 60 + 10 * sin(t / 20.0);
        z = truth + 3 * noise() + (t % 17 == 16 ? 150 : 0);
        memmove(window, window + 1, 4 * sizeof *window);
        window[4] = z;
        low += 0.2 * (z - low);
        estimates[0] = update(&k, z);
        estimates[1] = t < 4 ? z : median5(window);
        estimates[2] = low;
        for (i = 0; i < 3; i++)
            error[i] += fabs(estimates[i] - truth);
        if (t % 12 == 11)
            printf("%d %.4f %.4f %.4f %.4f\n", t, truth, estimates[0], estimates[1], estimates[2]);
    }
    printf("%.3f %.3f %.3f\n", error[0] / 60, error[1] / 60, error[2] / 60);
    return 0;
}
