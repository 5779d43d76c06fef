/* Absurd formats: widths, precisions, missing arguments, unknown conversions, no end. */
// ends: any
#include <stdio.h>

int main(void)
{
    char small[4];

    printf("%.500f\n", 1e300);
    printf("%1000d|%-1000s|\n", 1, "x");
    printf("%*.*d\n", -50, -1, 3);
    printf("%s %d %f\n");
    printf("%y %");
    snprintf(small, sizeof small, "%2147483647d", 1);
    snprintf(small, sizeof small, "%.2147483647f", 1.0);
    return 0;
}
