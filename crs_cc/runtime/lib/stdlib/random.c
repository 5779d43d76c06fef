/* Pseudo-random numbers (C17 7.22.2; random and srandom: POSIX).

   The additive feedback generator of BSD's random(3): x[n] = x[n-3] + x[n-31] modulo 2^32, of which
   the upper 31 bits are given, its first 31 numbers made from the seed by the minimal standard
   generator of Park and Miller, x[n] = 16807 x[n-1] modulo 2^31 - 1 (CACM 31, 1988), the first 310
   results thrown away. It is also Linux's, so a seed gives the numbers it gave on the real host. */
#include <stdlib.h>

#define DEGREE 31
#define SEPARATION 3

static unsigned int state[DEGREE];
static int newest = -1;

static unsigned int next(void)
{
    int oldest = newest + 1 < DEGREE ? newest + 1 : 0;
    int near = oldest < SEPARATION ? oldest + DEGREE - SEPARATION : oldest - SEPARATION;

    newest = oldest;
    state[oldest] += state[near];
    return state[oldest] >> 1;
}

static void seed_with(unsigned int seed)
{
    int value = seed == 0 ? 1 : (int)seed;
    int i;

    for (i = 0; i < DEGREE; i++) {
        state[i] = value;
        value = 16807LL * value % 2147483647;
        if (value < 0)
            value += 2147483647;
    }
    newest = SEPARATION - 1;
    for (i = 0; i < 310; i++)
        next();
}

void srandom(unsigned int seed)
{
    seed_with(seed);
}

/* Without a seed the numbers are those of seed 1 (C17 7.22.2.2). */
long random(void)
{
    if (newest < 0)
        seed_with(1);
    return next();
}

void srand(unsigned int seed)
{
    seed_with(seed);
}

int rand(void)
{
    if (newest < 0)
        seed_with(1);
    return next();
}
