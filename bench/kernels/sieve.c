/* Sieve of Eratosthenes over bytes: tight loops, indexed stores. */
#include <stdio.h>
#include <string.h>

#define SIZE 1000000

static char composite[SIZE + 1];

int main(void)
{
    int round, i, j, count = 0;

    for (round = 0; round < 12; round++) {
        memset(composite, 0, sizeof composite);
        count = 0;
        for (i = 2; i <= SIZE; i++) {
            if (composite[i])
                continue;
            count++;
            for (j = i + i; j <= SIZE; j += i)
                composite[j] = 1;
        }
    }
    printf("sieve %d\n", count);
    return 0;
}
