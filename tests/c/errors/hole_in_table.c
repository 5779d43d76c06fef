/* A table of functions with a hole in it. */
#include <stdio.h>

static void go(void) { printf("go\n"); }
static void stop(void) { printf("stop\n"); }
static void (*const table[4])(void) = { go, [2] = stop };

int main(void)
{
    int i;

    for (i = 0; i < 4; i++)
        table[i](); // error: bad function pointer
    return 0;
}
