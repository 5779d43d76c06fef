/* Pseudo-random numbers (C17 7.22.2; random, srandom, initstate, setstate, rand_r: POSIX).

   The additive feedback generator of BSD's random(3): x[n] = x[n-s] + x[n-d] modulo 2^32, of which
   the upper 31 bits are returned, its first d numbers made from the seed by the minimal standard
   generator of Park and Miller, x[n] = 16807 x[n-1] modulo 2^31 - 1 (CACM 31, 1988), the first 10 d
   results discarded; d = 31 and s = 3 unless a program passes a state of another size. It is also
   Linux's, so a seed yields the same numbers as on the real host. */
#include <errno.h>
#include <stdlib.h>

#define KINDS 5

static const unsigned char degrees[KINDS] = {0, 7, 15, 31, 63};
static const unsigned char separations[KINDS] = {0, 3, 1, 3, 1};

/* A state is a word that says its kind, and while it is set aside its place, and `degree` numbers,
   or one where the degree is 0: that is the generator x[n] = 1103515245 x[n-1] + 12345. */
static unsigned int own[32] = {3};
static unsigned int *state = own;
static int newest = -1;

static unsigned int next(void)
{
    int degree = degrees[*state], separation = separations[*state];
    unsigned int *numbers = state + 1;
    int oldest, near;

    if (degree == 0)
        return *numbers = (*numbers * 1103515245 + 12345) & 0x7fffffff;
    oldest = newest + 1 < degree ? newest + 1 : 0;
    near = oldest < separation ? oldest + degree - separation : oldest - separation;
    newest = oldest;
    numbers[oldest] += numbers[near];
    return numbers[oldest] >> 1;
}

static void seed_with(unsigned int seed)
{
    int value = seed == 0 ? 1 : (int)seed;
    int degree = degrees[*state];
    int i;

    state[1] = value;
    newest = 0;
    if (degree == 0)
        return;
    for (i = 0; i < degree; i++) {
        state[1 + i] = value;
        value = 16807LL * value % 2147483647;
        if (value < 0)
            value += 2147483647;
    }
    newest = separations[*state] - 1;
    for (i = 0; i < 10 * degree; i++)
        next();
}

/* Without a seed the numbers are those of seed 1 (C17 7.22.2.2). */
static unsigned int number(void)
{
    if (newest < 0)
        seed_with(1);
    return next();
}

void srandom(unsigned int seed)
{
    seed_with(seed);
}

long random(void)
{
    return number();
}

void srand(unsigned int seed)
{
    seed_with(seed);
}

int rand(void)
{
    return number();
}

/* Notes the place in the present state, so that it can be taken up again. */
static char *set_aside(void)
{
    if (newest < 0)
        seed_with(1);
    *state += KINDS * newest;
    return (char *)state;
}

char *initstate(unsigned int seed, char *memory, size_t size)
{
    char *before;

    if (size < 8) {
        errno = EINVAL;
        return NULL;
    }
    before = set_aside();
    state = (unsigned int *)memory;
    *state = size < 32 ? 0 : size < 64 ? 1 : size < 128 ? 2 : size < 256 ? 3 : 4;
    seed_with(seed);
    return before;
}

char *setstate(char *memory)
{
    char *before = set_aside();

    state = (unsigned int *)memory;
    newest = *state / KINDS;
    *state %= KINDS;
    return before;
}

/* Three steps of the generator of degree 0, of 11, 10 and 10 bits each. */
int rand_r(unsigned int *seed)
{
    unsigned int x = *seed, result;

    x = x * 1103515245 + 12345;
    result = (x >> 16) % 2048;
    x = x * 1103515245 + 12345;
    result = result << 10 ^ (x >> 16) % 1024;
    x = x * 1103515245 + 12345;
    result = result << 10 ^ (x >> 16) % 1024;
    *seed = x;
    return result;
}
