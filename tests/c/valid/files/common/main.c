#include <stdio.h>
#include "shared.h"

static int turn(int n) { return n + 1; }

int main(void)
{
    steps = turn(1);
    advance();
    printf("%d %d %s\n", steps, limit, label);
    return 0;
}
