/* A handler that registers itself again: exit() never ends. */
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
