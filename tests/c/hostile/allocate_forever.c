/* Allocates and writes without asking whether it got anything. */
// ends: wild pointer
#include <stdlib.h>

int main(void)
{
    for (;;) {
        char *p = malloc(100000);
        p[0] = p[99999] = 1;
    }
}
