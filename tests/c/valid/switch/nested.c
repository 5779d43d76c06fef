/* switch inside switch and loops; break and continue bind to the nearest of their kind. */
#include <stdio.h>

static int decode(int major, int minor)
{
    int r = 0;

    switch (major) {
    case 1:
        switch (minor) {
        case 1:
            r = 11;
            break;
        case 2:
            r = 12;
        default:
            r += 100;
        }
        r *= 2;
        break;
    case 2:
        if (minor) {
            switch (minor)
            case 5:
                return 25;
    case 3:
            r = 3;
        }
        r += minor;
    }
    return r;
}

int main(void)
{
    int i, j, n = 0;

    for (i = 0; i < 5; i++) {
        for (j = 0; j < 6; j++)
            printf("%d ", decode(i, j));
        printf("\n");
    }
    for (i = 0; i < 10; i++) {
        switch (i % 4) {
        case 0:
            continue;
        case 1:
            n += 1;
            break;
        case 2:
            while (1) {
                n += 10;
                if (n % 3 == 0)
                    break;
                if (n > 200)
                    goto out;
            }
            continue;
        default:
            if (i == 7)
                break;
            n += 1000;
        }
        n++;
    }
out:
    printf("%d %d\n", i, n);
    return 0;
}
