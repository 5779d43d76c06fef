/* exit() from deep inside ends the program and flushes the output. */
#include <stdio.h>
#include <stdlib.h>

static int dive(int depth)
{
    printf("%d ", depth);
    if (depth == 9) {
        printf("out");
        exit(depth);
    }
    return dive(depth + 1) + 1;
}

// exit: 9
int main(void)
{
    printf("%d\n", dive(0));
    return 0;
}
