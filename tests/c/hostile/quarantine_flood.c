/* Gives back far more than the quarantine holds, in every size, for ever. */
// ends: running
#include <stdlib.h>

int main(void)
{
    unsigned seed = 1;

    for (;;) {
        seed = seed * 1103515245u + 12345u;
        free(malloc(seed >> 12));
    }
}
