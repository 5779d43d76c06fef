/* Casts change comparisons and conditions. */
#include <stdio.h>

int main(void)
{
    int i = -1;
    unsigned char c = 128;
    double d = 0.4;
    long long ll = 4294967296ll;
    int *p = 0;

    printf("%d %d\n", (unsigned) i > 5, i > 5);
    printf("%d %d\n", (signed char) c < 0, c < 0);
    printf("%d %d\n", (int) d ? 1 : 0, d ? 1 : 0);
    printf("%d %d\n", (int) ll ? 1 : 0, ll ? 1 : 0);
    if ((int) ll)
        printf("no\n");
    if (ll)
        printf("yes\n");
    if (d)
        printf("a fraction is true\n");
    if (!p)
        printf("a null pointer is false\n");
    printf("%d\n", !ll);
    printf("%d\n", (short) 65536 == 0);
    printf("%d\n", (float) 0.1 == 0.1);
    while ((unsigned char) i--)
        if (i < -300)
            break;
    printf("%d\n", i);
    (void) printf("done\n");
    return 0;
}
