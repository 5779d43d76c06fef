/* Copies and clears with sizes that wrap around the end of all addresses. */
// ends: out of bounds
#include <string.h>

static char here[16], there[16];

int main(void)
{
    memmove(here, there, 0xfffffff0u);
    memset(here, 1, 0xffffffffu);
    return 0;
}
