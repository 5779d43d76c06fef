/* Integer division truncates towards zero; (a/b)*b + a%b == a (C17 6.5.5p6). */
#include <stdio.h>

int main(void)
{
    int values[] = { -100, -7, -1, 1, 3, 99, 1000 };
    int count = sizeof values / sizeof values[0];
    int i, j, ok = 1;
    short s = -32768;
    unsigned char uc = 250;

    for (i = 0; i < count; i++) {
        for (j = 0; j < count; j++) {
            int a = values[i], b = values[j];
            if (a / b * b + a % b != a)
                ok = 0;
            printf("%d,%d ", a / b, a % b);
        }
        printf("\n");
    }
    printf("%d\n", ok);
    printf("%d %d\n", s / -1, s % 7);
    printf("%d %u\n", uc / -3, uc / 3u);
    printf("%u %u\n", 4000000000u / 3, 4000000000u % 7);
    printf("%d\n", 2147483647 / -2147483647);
    uc /= 7;
    uc %= 10;
    s /= 100;
    printf("%d %d\n", uc, s);
    return 0;
}
