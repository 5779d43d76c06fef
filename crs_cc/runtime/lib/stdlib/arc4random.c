/* BSD's random numbers without a seed. Here the seed is fixed, so that a run can be
   repeated: a counter passed through the finaliser of MurmurHash3 (Appleby, 2011), whose every
   input bit changes every output bit. They are not secret. */
#include <stdlib.h>

static unsigned int counter;

static unsigned int mixed(unsigned int x)
{
    x ^= x >> 16;
    x *= 0x85ebca6bu;
    x ^= x >> 13;
    x *= 0xc2b2ae35u;
    return x ^ x >> 16;
}

static unsigned int next(void)
{
    counter += 0x9e3779b9u;    /* 2^32 over the golden ratio */
    return mixed(counter);
}

unsigned int arc4random(void)
{
    return next();
}

/* Numbers below the largest multiple of `bound` are as many for each remainder; others are drawn
   again. */
unsigned int arc4random_uniform(unsigned int bound)
{
    unsigned int least, number;

    if (bound < 2)
        return 0;
    least = -bound % bound;
    do
        number = next();
    while (number < least);
    return number % bound;
}

void arc4random_buf(void *buffer, size_t size)
{
    unsigned char *bytes = buffer;
    size_t i;

    for (i = 0; i < size; i++)
        bytes[i] = next() >> 24;
}
