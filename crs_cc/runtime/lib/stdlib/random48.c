/* Pseudo-random numbers of System V (POSIX drand48): x[n + 1] = (a x[n] + c) modulo 2^48, with
   a = 0x5deece66d and c = 11 unless lcong48 says otherwise. */
#include <stdlib.h>

static unsigned short state[3] = {0, 0, 0}, seed_before[3];
static unsigned long long factor = 0x5deece66dULL;
static unsigned short addend = 11;

/* Advances a state and returns its 48 bits. */
static unsigned long long step(unsigned short x[3])
{
    unsigned long long value = (unsigned long long)x[2] << 32 | (unsigned int)x[1] << 16 | x[0];

    value = value * factor + addend;
    x[0] = value;
    x[1] = value >> 16;
    x[2] = value >> 32;
    return value & 0xffffffffffffULL;
}

static double fraction(unsigned short x[3])
{
    return step(x) * 0x1p-48;
}

static long upper_31(unsigned short x[3])
{
    return step(x) >> 17;
}

static long upper_32(unsigned short x[3])
{
    return (int)(unsigned int)(step(x) >> 16);
}

double drand48(void)
{
    return fraction(state);
}

double erand48(unsigned short x[3])
{
    return fraction(x);
}

long lrand48(void)
{
    return upper_31(state);
}

long nrand48(unsigned short x[3])
{
    return upper_31(x);
}

long mrand48(void)
{
    return upper_32(state);
}

long jrand48(unsigned short x[3])
{
    return upper_32(x);
}

static unsigned short *set_seed(const unsigned short seed[3])
{
    __builtin_memcpy(seed_before, state, sizeof state);
    __builtin_memcpy(state, seed, sizeof state);
    factor = 0x5deece66dULL;
    addend = 11;
    return seed_before;
}

unsigned short *seed48(unsigned short seed[3])
{
    return set_seed(seed);
}

void srand48(long seed)
{
    unsigned short start[3];

    start[0] = 0x330e;
    start[1] = seed;
    start[2] = (unsigned long)seed >> 16;
    set_seed(start);
}

/* Sets state, factor and addend, each 16 bits a number, the lowest first. */
void lcong48(unsigned short parameters[7])
{
    __builtin_memcpy(state, parameters, sizeof state);
    factor = parameters[3] | (unsigned long long)parameters[4] << 16 |
             (unsigned long long)parameters[5] << 32;
    addend = parameters[6];
}
