/* What was one block is two after it was freed; what is known of it must not stay. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    char *whole = malloc(300000), *first = whole, *second = whole + 200;
    int total = 0;

    total += second - first;
    free(whole); /* more than the quarantine holds */
    first = malloc(100);
    second = malloc(100);
    total += second - first; // error: unrelated pointers
    printf("%d\n", total);
    return 0;
}
