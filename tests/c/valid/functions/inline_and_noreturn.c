/* inline, _Noreturn, register and restrict are accepted and have no effect. */
#include <stdio.h>
#include <stdlib.h>

static inline int square(register int n) { return n * n; }
_Noreturn static void stop(int status) { printf("stopping\n"); exit(status); }

static void copy(char *restrict to, const char *restrict from, register unsigned n)
{
    while (n--)
        *to++ = *from++;
}

// exit: 3
int main(void)
{
    register int i;
    auto int sum = 0;
    char b[6];

    for (i = 0; i < 4; i++)
        sum += square(i);
    copy(b, "steer", 6);
    printf("%d %s\n", sum, b);
    if (sum == 14)
        stop(3);
    printf("never\n");
}
