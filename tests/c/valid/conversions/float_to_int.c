/* Floating to integer conversion truncates towards zero (C17 6.3.1.4). */
#include <stdio.h>

int main(void)
{
    double values[] = { 0.0, 0.9, -0.9, 1.5, -1.5, 127.99, 255.5, 32767.9, 2147483647.0,
                        -2147483648.0, 1e-10 };
    float f = 3.99f;
    int i;

    for (i = 0; i < (int) (sizeof values / sizeof *values); i++) {
        int n = values[i];
        long long ll = (long long) values[i];
        printf("%d %lld\n", n, ll);
    }
    printf("%u %u\n", (unsigned) 4294967295.0, (unsigned) 3000000000.7);
    printf("%lld %lld\n", (long long) 9.2e18, (long long) -9.2e18);
    printf("%llu\n", (unsigned long long) 1.8e19);
    printf("%d %d\n", (char) 65.9, (short) -300.2);
    printf("%d %d\n", (int) f, (unsigned char) 200.7f);
    printf("%d\n", (int) -f);
    i = 2.9 + 2.9;
    printf("%d\n", i);
    i = (int) 2.9 + (int) 2.9;
    printf("%d\n", i);
    return 0;
}
