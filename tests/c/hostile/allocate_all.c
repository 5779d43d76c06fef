/* Takes all memory in ever smaller pieces and writes to each. */
// ends: exit 0
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void)
{
    unsigned size, total = 0;
    char *p;

    for (size = 1u << 31; size; size /= 2)
        while ((p = malloc(size))) {
            p[0] = p[size - 1] = 1;
            total += size;
        }
    printf("%s\n", total > 1000000 ? "took all there was" : "too little");
    return malloc(1) != 0;
}
