/* Text to numbers: atoi, strtol in all bases, strtod, sprintf back. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void)
{
    const char *numbers[] = { "0", "42", "-17", "  +8x", "0x1F", "077", "abc", "2147483647", "-2147483648" };
    const char *reals[] = { "3.14", "-2.5e3", "1e-2xyz", ".5", "7.", "0x1p3", "inf", "-0", "1e400" };
    char *end, buffer[32];
    int i;

    for (i = 0; i < 9; i++) {
        long d = strtol(numbers[i], &end, 10);
        printf("%d %ld %d ", atoi(numbers[i]), d, (int) (end - numbers[i]));
        d = strtol(numbers[i], &end, 0);
        printf("%ld %d\n", d, (int) (end - numbers[i]));
    }
    printf("%ld %ld %lu\n", strtol("ff", 0, 16), strtol("-101", 0, 2), strtoul("4294967295", 0, 10));
    printf("%lld %ld\n", strtoll("-9000000000", 0, 10), strtol("99999999999", 0, 10));
    printf("%ld %d\n", strtol("zz", &end, 36), *end);
    for (i = 0; i < 9; i++) {
        double d = strtod(reals[i], &end);
        printf("%g [%s] ", d, end);
    }
    printf("\n%g\n", atof("12.75abc"));
    for (i = 0; i < 5; i++) {
        sprintf(buffer, "%.*g", 3 * i + 1, 2.0 / 3);
        printf("%s %g\n", buffer, strtod(buffer, 0));
    }
    return 0;
}
