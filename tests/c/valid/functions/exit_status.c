/* The status is what main returns; atexit handlers run last registered first. */
#include <stdio.h>
#include <stdlib.h>

static void first(void) { printf("first registered, last run\n"); }
static void second(void) { printf("second\n"); }

// exit: 42
int main(void)
{
    atexit(first);
    atexit(second);
    printf("main ends");
    return 40 + 2;
}
