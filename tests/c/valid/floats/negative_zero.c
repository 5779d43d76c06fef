/* The sign of zero survives negation, products and storage. */
#include <stdio.h>
#include <string.h>

static unsigned high_word(double d)
{
    unsigned words[2];

    memcpy(words, &d, sizeof d);
    return words[1];
}

int main(void)
{
    double zero = 0.0, minus = -zero;
    float f = -0.0f;
    double table[2] = { -0.0, 0.0 };

    printf("%g %g %g\n", zero, minus, -minus);
    printf("%x %x\n", high_word(zero), high_word(minus));
    printf("%x %x\n", high_word(table[0]), high_word(table[1]));
    printf("%x\n", high_word(f));
    printf("%g %g\n", 0 - zero, -zero);
    printf("%g %g\n", zero * -5, minus + zero);
    printf("%d\n", minus == zero);
    printf("%g\n", minus - zero);
    minus = -minus;
    printf("%x\n", high_word(minus));
    printf("%x\n", high_word(-(double) 0));
    return 0;
}
