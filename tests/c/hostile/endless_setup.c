/* A handler that registers itself again: exit() never ends. */
// ends: running
#include <stdlib.h>

static void again(void)
{
    atexit(again);
}

int main(void)
{
    again();
    exit(0);
}
