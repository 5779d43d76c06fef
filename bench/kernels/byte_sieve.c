/* A sieve of Eratosthenes with a byte for each number, marked and counted through pointers. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int sieve(unsigned char *composite, int size)
{
    unsigned char *p, *end = composite + size;
    int i, count = 0;

    memset(composite, 0, size);
    for (i = 2; i * i < size; i++)
        if (!composite[i])
            for (p = composite + i * i; p < end; p += i)
                *p = 1;
    for (p = composite + 2; p < end; p++)
        count += !*p;
    return count;
}

int main(void)
{
    int size = 400000, total = 0, round;
    unsigned char *composite = malloc(size);

    for (round = 0; round < 60; round++)
        total += sieve(composite, size - round);
    printf("byte_sieve %d\n", total);
    free(composite);
    return 0;
}
