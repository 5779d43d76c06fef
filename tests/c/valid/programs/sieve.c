/* Prime sieve, prime gaps, factorisation, Goldbach pairs. */
#include <stdio.h>

#define LIMIT 2000
static char composite[LIMIT + 1];
static int primes[400], count;

static void sieve(void)
{
    int i, j;

    for (i = 2; i <= LIMIT; i++) {
        if (composite[i])
            continue;
        primes[count++] = i;
        for (j = i * i; j <= LIMIT; j += i)
            composite[j] = 1;
    }
}

static void factor(int n)
{
    int i;

    printf("%d =", n);
    for (i = 0; i < count && primes[i] * primes[i] <= n; i++)
        while (n % primes[i] == 0) {
            printf(" %d", primes[i]);
            n /= primes[i];
        }
    if (n > 1)
        printf(" %d", n);
    printf("\n");
}

int main(void)
{
    int i, gap = 0, at = 0, pairs = 0;

    sieve();
    printf("%d primes, last %d\n", count, primes[count - 1]);
    for (i = 1; i < count; i++)
        if (primes[i] - primes[i - 1] > gap)
            gap = primes[i] - primes[at = i - 1];
    printf("gap %d after %d\n", gap, primes[at]);
    factor(360360);
    factor(1999 * 1997);
    factor(1048576);
    for (i = 0; primes[i] <= 500; i++)
        if (!composite[1000 - primes[i]])
            pairs++;
    printf("%d\n", pairs);
    return 0;
}
