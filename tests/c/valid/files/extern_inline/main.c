/* GNU's extern inline in a header, with the real definition in another file. */
#include <stdio.h>
#include "scale.h"
int main(void) {
    printf("%d %d\n", scale(4), other(4));
    return 0;
}
