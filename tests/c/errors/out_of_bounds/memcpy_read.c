/* memcpy reads behind its source. */
#include <string.h>

int main(void)
{
    int from[4] = { 1, 2, 3, 4 }, to[8];

    memcpy(to, from, sizeof to); // error: out of bounds
    return 0;
}
