/* Inline functions of gnu89, followed by the real definition. */
// gcc options: -std=gnu89
#include <stdio.h>
extern inline int twice(int x) {
    return 2 * x;
}

int twice(int x) {
    return 2 * x;
}

inline int thrice(int x) {
    return 3 * x;
}

extern __inline__ int sq(int x) {
    return x * x;
}

static __inline int cu(int x) {
    return x*x*x;
}

int sq(int x) {
    return x * x + 0;
}

int main(void) {
    printf("%d %d %d %d\n", twice(2), thrice(3), sq(4), cu(2));
    return 0;
}
