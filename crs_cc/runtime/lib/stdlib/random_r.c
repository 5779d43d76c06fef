/* Reentrant pseudo-random numbers (GNU random_r and its relatives), see random.c. */
#include <errno.h>
#include <stdlib.h>

#define KINDS 5

static const unsigned char degrees[KINDS] = {0, 7, 15, 31, 63};
static const unsigned char separations[KINDS] = {0, 3, 1, 3, 1};

static unsigned int next(struct random_data *data)
{
    unsigned int *numbers = (unsigned int *)data->state, result;

    if (data->rand_type == 0)
        return *numbers = (*numbers * 1103515245 + 12345) & 0x7fffffff;
    result = *data->fptr += (unsigned int)*data->rptr;
    if (++data->fptr == data->end_ptr)
        data->fptr = data->state;
    if (++data->rptr == data->end_ptr)
        data->rptr = data->state;
    return result >> 1;
}

static void seed_with(unsigned int seed, struct random_data *data)
{
    int value = seed == 0 ? 1 : (int)seed;
    int i;

    data->state[0] = value;
    if (data->rand_type == 0)
        return;
    for (i = 0; i < data->rand_deg; i++) {
        data->state[i] = value;
        value = 16807LL * value % 2147483647;
        if (value < 0)
            value += 2147483647;
    }
    data->fptr = data->state + data->rand_sep;
    data->rptr = data->state;
    for (i = 0; i < 10 * data->rand_deg; i++)
        next(data);
}

int random_r(struct random_data *data, int *result)
{
    *result = next(data);
    return 0;
}

int srandom_r(unsigned int seed, struct random_data *data)
{
    seed_with(seed, data);
    return 0;
}

static void take_up(struct random_data *data, int kind, int *numbers)
{
    data->state = numbers;
    data->rand_type = kind;
    data->rand_deg = degrees[kind];
    data->rand_sep = separations[kind];
    data->end_ptr = numbers + data->rand_deg;
}

/* Notes the kind and the place in front of the numbers, so that they can be taken up again. */
static void set_aside(struct random_data *data)
{
    int place = data->rand_type == 0 ? 0 : data->rptr - data->state;

    data->state[-1] = KINDS * place + data->rand_type;
}

int initstate_r(unsigned int seed, char *memory, size_t size, struct random_data *data)
{
    if (size < 8) {
        errno = EINVAL;
        return -1;
    }
    if (data->state != NULL)
        set_aside(data);
    take_up(data, size < 32 ? 0 : size < 64 ? 1 : size < 128 ? 2 : size < 256 ? 3 : 4,
            (int *)memory + 1);
    seed_with(seed, data);
    set_aside(data);
    return 0;
}

int setstate_r(char *memory, struct random_data *data)
{
    int *numbers = (int *)memory + 1;
    int kind = numbers[-1] % KINDS, place = numbers[-1] / KINDS;

    set_aside(data);
    take_up(data, kind, numbers);
    if (kind != 0) {
        data->rptr = numbers + place;
        data->fptr = numbers + (place + data->rand_sep) % data->rand_deg;
    }
    return 0;
}
