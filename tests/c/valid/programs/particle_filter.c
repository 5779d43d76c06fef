/* A particle filter along a corridor with doors: own random numbers, weights, resampling. */
#include <math.h>
#include <stdio.h>

#define PARTICLES 100
#define LENGTH 100.0

static const double doors[] = { 10, 25, 30, 62, 85 };
static unsigned seed = 12345;

static double uniform(void)
{
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216.0;
}

static double noise(double size)
{
    double sum = 0;
    for (int i = 0; i < 12; i++)
        sum += uniform();
    return (sum - 6) * size;
}

static int sees_door(double x)
{
    for (unsigned i = 0; i < sizeof doors / sizeof *doors; i++)
        if (fabs(x - doors[i]) < 2)
            return 1;
    return 0;
}

static double particles[PARTICLES], weights[PARTICLES];

static void resample(void)
{
    static double chosen[PARTICLES];
    double total = 0, step, at, sum;
    int i, j = 0;

    for (i = 0; i < PARTICLES; i++)
        total += weights[i];
    step = total / PARTICLES;
    at = uniform() * step;
    sum = weights[0];
    for (i = 0; i < PARTICLES; i++, at += step) {
        while (sum < at && j < PARTICLES - 1)
            sum += weights[++j];
        chosen[i] = particles[j];
    }
    for (i = 0; i < PARTICLES; i++)
        particles[i] = chosen[i];
}

int main(void)
{
    double x = 5;

    for (int i = 0; i < PARTICLES; i++)
        particles[i] = uniform() * LENGTH;
    for (int turn = 1; turn <= 20; turn++) {
        double mean = 0, spread = 0;
        int seen;
        x += 1.5 + noise(0.05);
        seen = sees_door(x) ^ (uniform() < 0.02);
        for (int i = 0; i < PARTICLES; i++) {
            particles[i] += 1.5 + noise(0.2);
            weights[i] = sees_door(particles[i]) == seen ? 0.9 : 0.1;
        }
        resample();
        for (int i = 0; i < PARTICLES; i++)
            mean += particles[i] / PARTICLES;
        for (int i = 0; i < PARTICLES; i++)
            spread += pow(particles[i] - mean, 2) / PARTICLES;
        if (turn % 8 == 0)
            printf("%2d: at %.2f, believes %.2f +- %.2f\n", turn, x, mean, sqrt(spread));
    }
    return 0;
}
