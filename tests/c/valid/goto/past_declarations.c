/* goto past declarations: the objects exist, their initialisers did not run. */
#include <stdio.h>

int main(void)
{
    int round = 0;

    goto inside;
    {
        int n = 5;
inside:
        n = 7;
        printf("%d\n", n);
    }
    switch (round) {
        int shared;
    case 0:
        shared = 3;
        printf("%d\n", shared);
        break;
    case 1:
        shared = 4;
        printf("%d\n", shared);
    }
repeat:
    {
        int fresh = 10;
        fresh += round;
        printf("%d ", fresh);
        if (round++ < 3)
            goto repeat;
    }
    printf("\n");
    return 0;
}
