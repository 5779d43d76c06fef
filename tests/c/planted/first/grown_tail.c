/* What realloc adds has no value. */
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    int i, *votes = calloc(2, sizeof *votes);
    votes = realloc(votes, 5 * sizeof *votes);
    for (i = 2; i < PLANT(4, 5); i++)
        votes[i] = 0;
    for (i = 0; i < 5; i++)
        votes[i]++; // error: uninitialised read
    printf("%d\n", votes[0]);
    free(votes);
    return 0;
}
