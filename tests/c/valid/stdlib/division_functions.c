/* abs, labs, div, ldiv and friends. */
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    div_t d = div(-17, 5);
    ldiv_t l = ldiv(1000000007L, 1000L);
    lldiv_t ll = lldiv(-10000000000ll, 3);

    printf("%d %ld %lld\n", abs(-5), labs(-123456L), llabs(-5000000000ll));
    printf("%d %d\n", d.quot, d.rem);
    printf("%ld %ld\n", l.quot, l.rem);
    printf("%lld %lld\n", ll.quot, ll.rem);
    printf("%d\n", div(17, -5).rem);
    printf("%d %d\n", EXIT_SUCCESS, EXIT_FAILURE != 0);
    return 0;
}
