/* rand is repeatable after srand and stays in its range. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    int first[5], i, ok = 1, buckets[4] = { 0 };

    srand(7);
    for (i = 0; i < 5; i++)
        first[i] = rand();
    srand(7);
    for (i = 0; i < 5; i++)
        ok &= first[i] == rand();
    srand(8);
    ok &= first[0] != rand() || first[1] != rand();
    printf("%d\n", ok);
    for (i = 0; i < 1000; i++) {
        int r = rand();
        ok &= r >= 0 && r <= RAND_MAX;
        buckets[(int) (r / (RAND_MAX + 1.0) * 4)]++;
    }
    for (i = 0; i < 4; i++)
        ok &= buckets[i] > 150 && buckets[i] < 350;
    printf("%d\n", ok);
    return 0;
}
