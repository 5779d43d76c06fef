/* Six loops deep, with breaks and continues at each level. */
#include <stdio.h>

int main(void)
{
    int a, b, c, d, e, f, n = 0, hash = 0;

    for (a = 0; a < 4; a++) {
        b = 0;
        while (b < 4) {
            c = 0;
            b++;
            if (b == a)
                continue;
            do {
                c++;
                for (d = c; d < 5; d += 2) {
                    if (d == 4)
                        break;
                    for (e = 0;; e++) {
                        if (e > a)
                            break;
                        for (f = 0; f < 3; f++) {
                            if (f == e)
                                continue;
                            n++;
                            hash = (hash * 31 + a + 2 * b + 3 * c + 5 * d + 7 * e + 11 * f) % 1000003;
                        }
                    }
                }
            } while (c < b);
        }
    }
    printf("%d %d\n", n, hash);
    return 0;
}
