/* The generators of BSD and System V give the numbers that they always gave. */
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>

static void reentrant(void)
{
    static const int sizes[] = {8, 32, 200, 256};
    static char states[4][256];
    struct random_data data = {0};
    int i, k, number;

    for (i = 0; i < 4; i++) {
        initstate_r(i, states[i], sizes[i], &data);
        for (k = 0; k < 70; k++)
            random_r(&data, &number);
        printf("%d ", number);
    }
    for (i = 0; i < 4; i++) {
        setstate_r(states[i], &data);
        random_r(&data, &number);
        printf("%d ", number);
    }
    srandom_r(9, &data);
    random_r(&data, &number);
    printf("%d %d\n", number, initstate_r(1, states[0], 4, &data));
}

int main(void)
{
    unsigned int seed = 5;
    unsigned short x[3] = {1, 2, 3}, parameters[7] = {1, 2, 3, 4, 5, 6, 7};
    static char state[256];
    static const int sizes[] = {8, 32, 64, 128, 256};
    char *first = NULL;
    double fraction;
    int i, k;

    for (i = 0; i < 5; i++)
        printf("%d ", rand_r(&seed));
    printf("%f ", drand48());
    srand48(77);
    for (i = 0; i < 3; i++) {
        fraction = drand48();
        printf("%.15f %ld ", fraction, lrand48());
        printf("%ld %.12f ", mrand48(), erand48(x));
        printf("%ld %ld\n", nrand48(x), jrand48(x));
    }
    seed48(x);
    printf("%ld\n", lrand48());
    lcong48(parameters);
    printf("%ld %f\n", mrand48(), drand48());
    printf("%ld %d\n", random(), rand());
    for (i = 0; i < 5; i++) {
        char *before = initstate(42 + i, state, sizes[i]);
        if (i == 0)
            first = before;
        for (k = 0; k < 70; k++)
            random();
        printf("%ld %ld\n", random(), random());
    }
    setstate(first);
    printf("%ld\n", random());
    srandom(0);
    printf("%ld\n", random());
    reentrant();
    return 0;
}
