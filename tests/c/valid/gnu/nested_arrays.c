/* Nested functions and arrays of variable length. */
#include <stdio.h>

static int vl(int n) {
    int v[n];
    int sum(void) {
        int s = 0;
        for (int i = 0; i < n; i++) s += v[i];
        return s + sizeof v / sizeof *v;
    }
    for (int i = 0; i < n; i++) v[i] = i;
    return sum();
}

int main(void) {
    printf("%d\n", vl(4));
    return 0;
}
