/* Reentrant pseudo-random numbers of 48 bits (GNU drand48_r and its relatives), see random48.c. */
#include <stdlib.h>

#define FACTOR 0x5deece66dULL
#define ADDEND 11

static void prepare(struct drand48_data *data)
{
    if (!data->__init) {
        data->__a = FACTOR;
        data->__c = ADDEND;
        data->__init = 1;
    }
}

static unsigned long long step(unsigned short x[3], struct drand48_data *data)
{
    unsigned long long value = (unsigned long long)x[2] << 32 | (unsigned int)x[1] << 16 | x[0];

    prepare(data);
    value = value * data->__a + data->__c;
    x[0] = value;
    x[1] = value >> 16;
    x[2] = value >> 32;
    return value & 0xffffffffffffULL;
}

int erand48_r(unsigned short x[3], struct drand48_data *data, double *result)
{
    *result = step(x, data) * 0x1p-48;
    return 0;
}

int drand48_r(struct drand48_data *data, double *result)
{
    *result = step(data->__x, data) * 0x1p-48;
    return 0;
}

int nrand48_r(unsigned short x[3], struct drand48_data *data, long *result)
{
    *result = step(x, data) >> 17;
    return 0;
}

int lrand48_r(struct drand48_data *data, long *result)
{
    *result = step(data->__x, data) >> 17;
    return 0;
}

int jrand48_r(unsigned short x[3], struct drand48_data *data, long *result)
{
    *result = (int)(unsigned int)(step(x, data) >> 16);
    return 0;
}

int mrand48_r(struct drand48_data *data, long *result)
{
    *result = (int)(unsigned int)(step(data->__x, data) >> 16);
    return 0;
}

int seed48_r(unsigned short seed[3], struct drand48_data *data)
{
    __builtin_memcpy(data->__old_x, data->__x, sizeof data->__x);
    __builtin_memcpy(data->__x, seed, sizeof data->__x);
    data->__init = 0;
    prepare(data);
    return 0;
}

int srand48_r(long seed, struct drand48_data *data)
{
    unsigned short start[3];

    start[0] = 0x330e;
    start[1] = seed;
    start[2] = (unsigned long)seed >> 16;
    __builtin_memcpy(data->__x, start, sizeof start);
    data->__init = 0;
    prepare(data);
    return 0;
}

int lcong48_r(unsigned short parameters[7], struct drand48_data *data)
{
    __builtin_memcpy(data->__x, parameters, sizeof data->__x);
    data->__a = parameters[3] | (unsigned long long)parameters[4] << 16 |
                (unsigned long long)parameters[5] << 32;
    data->__c = parameters[6];
    data->__init = 1;
    return 0;
}
